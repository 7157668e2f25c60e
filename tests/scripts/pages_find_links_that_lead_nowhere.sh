# scripts/pages finds a link to a file or a heading that is not there, and takes the others.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$1/scripts" "$1/docs" "$1/apps" "$1/libs" "$1/benchmarks" "$1/share" "$1/examples" "$1"/*.md "$1"/action.yml \
  "$1/LICENSE" "$1/CITATION.cff" "$work"
cd "$work"

fail() { cat faults >&2; echo "FAILED: $*" >&2; exit 1; }

scripts/pages 2> faults || fail "a link of the tree leads nowhere"
cat >> README.md <<'END'
## A heading: of `code`, and a [link](docs/ci.md)

[here](#a-heading-of-code-and-a-link) [there](docs/scoring.md#how-many-runs-are-needed)

```
[quoted](docs/nothing.md)
```
END
scripts/pages 2> faults || fail "a good link is refused"
for link in docs/nothing.md docs/scoring.md#no-such-part '#no-such-part'; do
  cp README.md kept
  printf '\n[bad](%s)\n' "$link" >> README.md
  if scripts/pages 2> faults; then fail "$link is taken for good"; fi
  grep -q '^README.md: .*\(docs/nothing.md\|#no-such-part\)$' faults || fail "the fault is not told"
  [ "$(wc -l < faults)" -eq 1 ] || fail "one fault is told as several"
  mv kept README.md
done
