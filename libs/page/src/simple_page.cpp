#include "roomgraph/page/simple_page.h"

#include "page_files.h"
#include "roomgraph/base/version.h"

namespace roomgraph {

std::string simplePage(const SimplePage& page) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
         "'unsafe-inline'\">\n<meta name=\"viewport\" content=\"width=device-width, "
         "initial-scale=1\">\n<title>" +
         page.title + " - roomgraph</title>\n<style>" + page_files::kReportCss + page.style +
         "</style>\n</head>\n<body>\n<header class=\"top\">\n<p class=\"brand\">roomgraph <span>" +
         page.subject + "</span></p>\n<h1>" + page.heading + "</h1>\n<p class=\"counts\">" +
         page.counts + "</p>\n</header>\n<main>\n" + page.body +
         "</main>\n<footer><p>Made by roomgraph " + version() + ". " + page.footer +
         "</p></footer>\n</body>\n</html>\n";
}

}  // namespace roomgraph
