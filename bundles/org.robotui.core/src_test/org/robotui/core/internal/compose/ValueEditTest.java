package org.robotui.core.internal.compose;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;

class ValueEditTest {
  private static final ValueType TEXT = new ValueType.Text();
  private static final ValueType GROUP = new ValueType.Section(Schema.of(Setting.required("when", TEXT, "a condition"),
      Setting.optional("for", new ValueType.Num(0, 9, "s"), "how long")));
  private static final String ALERTS = """
      alerts:   # what is heard
        # the first
        - when: low    # charge
          for: 3
        # of the laser
        - {when: stale}

        # and more
        - when: hot
      end: 1
      """;
  private static final Map<String, Object> LOW = map("when", "low", "for", "3");
  private static final Map<String, Object> STALE = map("when", "stale");
  private static final Map<String, Object> HOT = map("when", "hot");
  private static final String NAMES = """
      views:
        a: {x: 1}
        # the other
        b:   # deep
          x: 2
      """;

  private static Map<String, Object> map(Object... pairs) {
    Map<String, Object> map = new LinkedHashMap<>();
    for (int i = 0; i < pairs.length; i += 2) {
      map.put(pairs[i].toString(), pairs[i + 1]);
    }
    return map;
  }

  private static String alerts(Object... now) throws PathEdit.Refusal {
    return new ValueEdit(List.of("alerts")).set(ALERTS, List.of(LOW, STALE, HOT), List.of(now),
        new ValueType.ListOf(GROUP));
  }

  @Test
  void whatFollowsFromAnotherSettingIsWrittenAsThatSays() throws PathEdit.Refusal {
    ValueType number = new ValueType.Section(Schema.of(Setting.optional("at", new ValueType.Num(0, 9, "s"), "when")));
    ValueType layer = new ValueType.Section(Schema.of(Setting.required("kind", TEXT, "which"), Setting.optional("with",
        new ValueType.Dependent("kind", Map.of("dots", number), new ValueType.MapOf(TEXT)), "settings")));
    Map<String, Object> before = map("kind", "dots");
    assertEquals("it: {kind: dots, with: {at: 5}}\n", new ValueEdit(List.of("it")).set("it: {kind: dots}\n", before,
        map("kind", "dots", "with", map("at", "5")), layer));
    assertEquals("it: {kind: own, with: {at: \"5\"}}\n", new ValueEdit(List.of("it")).set("it: {kind: dots}\n", before,
        map("kind", "own", "with", map("at", "5")), layer));
    assertEquals("{kind: dots, with: {at: 5}}", YamlWords.value(map("kind", "dots", "with", map("at", "5")), layer));
  }

  private static String views(Map<String, Object> now) throws PathEdit.Refusal {
    return new ValueEdit(List.of("views")).set(NAMES, map("a", map("x", "1"), "b", map("x", "2")), now,
        new ValueType.MapOf(new ValueType.MapOf(new ValueType.Num(0, 9, ""))));
  }

  @Test
  void oneItemOfAListIsChangedAndTheOthersStayAsTheyAreWritten() throws PathEdit.Refusal {
    assertEquals(ALERTS.replace("low ", "high "), alerts(map("when", "high", "for", "3"), STALE, HOT));
    assertEquals(ALERTS.replace("{when: stale}", "{when: stale, for: 2}"),
        alerts(LOW, map("when", "stale", "for", "2"), HOT));
    assertEquals(ALERTS.replace("    for: 3\n", ""), alerts(map("when", "low"), STALE, HOT));
    assertEquals(ALERTS, alerts(LOW, STALE, HOT));
  }

  @Test
  void itemsAreAddedAndTakenOut() throws PathEdit.Refusal {
    assertEquals(ALERTS.replace("hot\n", "hot\n  - {when: \"a: b\", for: 1}\n"),
        alerts(LOW, STALE, HOT, map("when", "a: b", "for", "1")));
    assertEquals(ALERTS.replace("- {when: stale}\n\n  # and", "# and").replace("# of the laser\n  # and",
        "# of the laser\n\n  # and"), alerts(LOW, HOT));
    assertEquals(ALERTS.replace("- when: low    # charge\n    for: 3\n", "# charge\n"), alerts(STALE, HOT));
    assertEquals("a: [{when: x}]\n", new ValueEdit(List.of("a")).set("a: [{when: y}, {when: x}]\n",
        List.of(map("when", "y"), map("when", "x")), List.of(map("when", "x")), new ValueType.ListOf(GROUP)));
  }

  @Test
  void itemsMoveWithTheirComments() throws PathEdit.Refusal {
    assertEquals("""
        alerts:   # what is heard
          # the first
          # of the laser
          - {when: stale}
          - when: low    # charge
            for: 3

          # and more
          - when: hot
        end: 1
        """, alerts(STALE, LOW, HOT));
    assertEquals("a: [z, x, y]\n", new ValueEdit(List.of("a")).set("a: [x, y, z]\n", List.of("x", "y", "z"),
        List.of("z", "x", "y"), new ValueType.ListOf(TEXT)));
  }

  @Test
  void entriesAreRenamedMovedAddedAndTakenOut() throws PathEdit.Refusal {
    assertEquals(NAMES.replace("b:", "c d:"), views(map("a", map("x", "1"), "c d", map("x", "2"))));
    assertEquals("views:\n  # the other\n  b:   # deep\n    x: 2\n  a: {x: 1}\n",
        views(map("b", map("x", "2"), "a", map("x", "1"))));
    assertEquals(NAMES.replace("1}", "3}").replace("x: 2\n", "x: 2\n  e: {x: 4}\n"),
        views(map("a", map("x", "3"), "b", map("x", "2"), "e", map("x", "4"))));
    assertEquals(NAMES.replace("  a: {x: 1}\n", ""), views(map("b", map("x", "2"))));
    assertEquals(NAMES.replace("b:   # deep", "new:   # deep").replace("x: 2", "x: 5"),
        views(map("a", map("x", "1"), "new", map("x", "5"))), "renamed and changed at once");
  }

  @Test
  void whatHasCommentsWithinItsBracesIsLeftToAnEditor() {
    PathEdit.Refusal refusal = assertThrows(PathEdit.Refusal.class, () -> new ValueEdit(List.of("a")).set(
        "b: 1\na: [x, # one\n  y]\n", List.of("x", "y"), List.of("y", "x"), new ValueType.ListOf(TEXT)));
    assertEquals(2, refusal.line());
    assertTrue(refusal.getMessage().contains("comments within its braces"), refusal.getMessage());
  }
}
