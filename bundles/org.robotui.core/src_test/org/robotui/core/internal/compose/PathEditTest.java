package org.robotui.core.internal.compose;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.api.config.ValueType;

class PathEditTest {
  private static final ValueType NUMBER = new ValueType.Num(0, 100, "");
  private static final ValueType TEXT = new ValueType.Text();
  private static final ValueType TEXTS = new ValueType.ListOf(TEXT);

  private static List<String> path(String path) {
    return List.of(path.split("/"));
  }

  private static String set(String text, String path, String number) throws PathEdit.Refusal {
    return PathEdit.set(text, path(path), number, NUMBER);
  }

  @Test
  void aValueIsReplacedAndWhatStandsBesideItStays() throws PathEdit.Refusal {
    assertEquals("a: # why\n  b:   2.5   # m/s\n  c: \"3\"\n",
        set("a: # why\n  b:   1   # m/s\n  c: \"3\"\n", "a/b", "2.5"));
    assertEquals("a: {b: 2, c: 3}  # x\n", set("a: {b: 1, c: 3}  # x\n", "a/b", "2"));
    assertEquals("a:\r\n  b: 2\r\n", set("a:\r\n  b: 1\r\n", "a/b", "2"));
    assertEquals("\u00fc: \ud83d\ude00\nb: 2\n", set("\u00fc: \ud83d\ude00\nb: 1\n", "b", "2"));
    assertEquals("a: 2 # nothing yet\n", set("a: # nothing yet\n", "a", "2"));
    assertEquals("a: 2\n", set("a: null\n", "a", "2"));
    assertEquals("a: {b: 2 }\n", set("a: {b: }\n", "a/b", "2"));
    assertEquals("a: {b: 2, c: 1}\n", set("a: {b, c: 1}\n", "a/b", "2"));
  }

  @Test
  void aTextIsWrittenSuchThatItIsReadAsOne() throws PathEdit.Refusal {
    assertEquals("a: \"yes\"\n", PathEdit.set("a: x\n", path("a"), "yes", TEXT));
    assertEquals("a: \"x # y\"\n", PathEdit.set("a: x\n", path("a"), "x # y", TEXT));
    assertEquals("a: http://robot:11311\n", PathEdit.set("a: x\n", path("a"), "http://robot:11311", TEXT));
  }

  @Test
  void aListKeepsItsStyle() throws PathEdit.Refusal {
    assertEquals("a:\n  - x\n  - z\nb: 1\n",
        PathEdit.set("a:\n  - x\n  - y\nb: 1\n", path("a"), List.of("x", "z"), TEXTS));
    assertEquals("a: [x, z]\n", PathEdit.set("a: [x]\n", path("a"), List.of("x", "z"), TEXTS));
    assertEquals("a: [] # why\nb: 1\n", PathEdit.set("a: # why\n  - x\nb: 1\n", path("a"), List.of(), TEXTS));
    assertEquals("a: []\nb: 1\n", PathEdit.set("a:\n  - x\nb: 1\n", path("a"), List.of(), TEXTS));
  }

  @Test
  void aSectionThatIsNotThereIsMadeAsItsNeighboursAre() throws PathEdit.Refusal {
    assertEquals("r:\n    k:\n        x: {}   # c\n        s:\n            K:\n                m: 2\n# end\nw: 1\n",
        set("r:\n    k:\n        x: {}   # c\n# end\nw: 1\n", "r/k/s/K/m", "2"));
    assertEquals("r: {n: {x: 1, s: {m: 2}}}\n", set("r: {n: {x: 1}}\n", "r/n/s/m", "2"));
    assertEquals("r: {n: {s: {m: 2} }}\n", set("r: {n: { }}\n", "r/n/s/m", "2"));
    assertEquals("r:\n  s: # empty\n    k:\n      m: 2\n  t: 1\n", set("r:\n  s: # empty\n  t: 1\n", "r/s/k/m", "2"));
    assertEquals("r: {s: {m: 2} , t: 1}\n", set("r: {s: , t: 1}\n", "r/s/m", "2"));
    assertEquals("r:\n  s: {m: 2}\n", set("r:\n  s: ~\n", "r/s/m", "2"));
    assertEquals("r:\n  a: 1\n  b: 2", set("r:\n  a: 1", "r/b", "2"));
    assertEquals("r:\n  a:\n  - x\n  b: 2\n", set("r:\n  a:\n  - x\n", "r/b", "2"));
  }

  @Test
  void aComponentOfOneWordBecomesASection() throws PathEdit.Refusal {
    assertEquals("ruics:\n  N:\n    rfics:\n      base: {type: ros, rate: 2} # c\n",
        set("ruics:\n  N:\n    rfics:\n      base: ros # c\n", "ruics/N/rfics/base/rate", "2"));
    assertEquals("'type' is no section there",
        assertThrows(PathEdit.Refusal.class, () -> set("ruics:\n  N:\n    type: x\n", "ruics/N/type/rate", "2"))
            .getMessage());
  }

  @Test
  void whatIsRemovedLeavesItsComment() throws PathEdit.Refusal {
    assertEquals("a:\n  c: 2\n", PathEdit.remove("a:\n  b: 1\n  c: 2\n", path("a/b")));
    assertEquals("a:\n  # m/s\n  c: 2\n", PathEdit.remove("a:\n  b: 1   # m/s\n  c: 2\n", path("a/b")));
    assertEquals("a:\n  c: 2\n", PathEdit.remove("a:\n  c: 2\n  b:\n    - 1\n    - 2\n", path("a/b")));
    assertEquals("a: {c: 2}\n", PathEdit.remove("a: {b: 1, c: 2}\n", path("a/b")));
    assertEquals("a: {b: 1}\n", PathEdit.remove("a: {b: 1, c: 2}\n", path("a/c")));
    assertEquals("a: {}\n", PathEdit.remove("a: {b: 1}\n", path("a/b")));
    assertEquals("a:\n", PathEdit.remove("a:\n  b: 1\n", path("a/b")));
    assertEquals("a:", PathEdit.remove("a:\n  b: 1", path("a/b")));
    assertEquals("a:\n  b: 1\n", PathEdit.remove("a:\n  b: 1\n", path("a/x/y")));
  }

  static Stream<List<String>> refused() {
    return Stream.of(
        List.of("a: &x {b: 1}\nc: *x\n", "a/b", "1", "'a' is shared"),
        List.of("a: &x {b: 1}\nc: *x\n", "c/b", "2", "'c' is shared"),
        List.of("a: &x 1\nc: *x\n", "a", "1", "'a' is shared"),
        List.of("r:\n  ${robot}: {for: r1..r3, m: 1}\n", "r/r2/m", "2", "'r2' may be formed by the template"),
        List.of("r:\n  n: {for: [a, b], m: 1}\n", "r/n/m", "2", "'n' may be formed by the template"),
        List.of("a:\n  b: >-\n    text\n", "a/b", "2", "the value has lines of its own"),
        List.of("a:\n  b:\n    - 1 # one\n    - 2\n", "a/b", "3", "the value has lines of its own or comments"),
        List.of("", "a", "1", "there is no configuration"));
  }

  @ParameterizedTest
  @MethodSource("refused")
  void whatMeansMoreThanOneThingIsRefusedWithItsPlace(List<String> given) {
    PathEdit.Refusal refusal =
        assertThrows(PathEdit.Refusal.class, () -> set(given.get(0), given.get(1), "7"));
    assertEquals(Integer.parseInt(given.get(3).startsWith("there") ? "1" : given.get(2)), refusal.line(),
        given::toString);
    assertTrue(refusal.getMessage().startsWith(given.get(3)), refusal.getMessage());
  }

  @Test
  void aNumberThatIsCalledForIsNoTemplate() throws PathEdit.Refusal {
    assertEquals("a: {for: 5, b: 2}\n", set("a: {for: 5, b: 1}\n", "a/b", "2"));
  }
}
