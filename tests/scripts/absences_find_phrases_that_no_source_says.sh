# scripts/absences finds a test that expects a phrase to be absent which no source has.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/scripts" "$work/libs" "$work/tests"
cp "$1/scripts/absences" "$work/scripts"
cd "$work"

fail() { cat faults >&2; echo "FAILED: $*" >&2; exit 1; }

cat > libs/said.cpp <<'END'
return "aligned with a "
       "confidence below " + limit;
END
cat > tests/good_unittest.cpp <<'END'
  const std::string text = saidOf("an input of two words");
  EXPECT_EQ(text.find("with a confidence below"), std::string::npos);
  EXPECT_EQ(text.find("input of two"), std::string::npos);
  EXPECT_NE(text.find("whatever is expected"), std::string::npos);
  EXPECT_EQ(text.find("<script src"), std::string::npos);
END
scripts/absences 2> faults || fail "a good test is refused"
echo '  EXPECT_EQ(text.find("confidence under"), std::string::npos);' > tests/bad_unittest.cpp
echo "! grep -q 'confidence over' out || fail 'a doubt'" > tests/bad.sh
if scripts/absences 2> faults; then fail "phrases that nobody says are taken for good"; fi
[ "$(wc -l < faults)" -eq 2 ] || fail "not two faults"
grep -q "bad_unittest.cpp:1: no source can say 'confidence under'" faults || fail "C++"
grep -q "bad.sh:1: no source can say 'confidence over'" faults || fail "shell"
