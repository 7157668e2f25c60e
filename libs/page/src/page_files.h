#pragma once

/** The files that make up the report, as text. The source is made by cmake/EmbedFiles.cmake. */
namespace roomgraph::page_files {

extern const char* const kReportHtml;
extern const char* const kReportCss;
extern const char* const kReportJs;
extern const char* const kReportToolsJs;
extern const char* const kLicencesTxt;
extern const char* const kLeafletCss;
extern const char* const kLeafletJs;
extern const char* const kD3Js;

}  // namespace roomgraph::page_files
