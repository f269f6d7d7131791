package org.robotui.ui.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;

class SettingNodeTest {
  private static final ValueType TEXT = new ValueType.Text();
  private static final ValueType NUMBER = new ValueType.Num(0, 10, "s");
  private static final Schema ALERT =
      Schema.of(Setting.required("when", TEXT, "a condition"), Setting.optional("for", NUMBER, "how long"));
  private static final BiFunction<Setting, Object, Optional<String>> CHECK = (setting, value) -> value.equals("wrong")
      ? Optional.of("'" + setting.name() + "' must be another one")
      : Optional.empty();

  private static SettingNode node(ValueType type, Object value) {
    return SettingNode.of(Setting.optional("it", type, "help"), Optional.ofNullable(value), CHECK);
  }

  private static SettingNode alerts(Object... alerts) {
    return node(new ValueType.ListOf(new ValueType.Section(ALERT)), alerts.length == 0 ? null : List.of(alerts));
  }

  private static List<String> problems(SettingNode node) {
    return node.problems("it").stream().map(p -> p.path() + ": " + p.sentence()).toList();
  }

  @Test
  void itemsAreAddedMovedAndRemoved() {
    SettingNode alerts = alerts();
    assertEquals(Optional.empty(), alerts.value());
    SettingNode first = alerts.add("");
    assertEquals(List.of("it/1/when: 'when' is needed: a condition"), problems(alerts));
    first.nodes().get(0).line().type("low");
    SettingNode second = alerts.add("");
    second.nodes().get(0).line().type("stale");
    second.nodes().get(1).line().type("3");
    alerts.move(second, -1);
    alerts.move(second, -1);
    assertEquals(List.of(Map.of("when", "stale", "for", "3"), Map.of("when", "low")), alerts.value().orElseThrow());
    alerts.remove(second);
    assertEquals(List.of(Map.of("when", "low")), alerts.value().orElseThrow());
    alerts.remove(first);
    assertEquals(Optional.empty(), alerts.value(), "no item is no list");
  }

  @Test
  void entriesKeepTheirOrderAndAreRenamed() {
    SettingNode speeds = node(new ValueType.MapOf(NUMBER), new LinkedHashMap<>(Map.of("b", "1")));
    speeds.add("a").line().type("2");
    speeds.nodes().getFirst().rename("c");
    assertEquals("{c=1, a=2}", speeds.value().orElseThrow().toString());
    speeds.add("d");
    assertEquals(List.of("it/d: is blank; write what is meant, or remove it"), problems(speeds));
  }

  @Test
  void aGroupOfNothingIsLeftOutAndItsOrderIsThatOfTheFile() {
    SettingNode group = node(new ValueType.Section(ALERT), null);
    assertEquals(Optional.empty(), group.value());
    assertEquals(List.of(), problems(group), "nobody has begun it");
    group.nodes().get(1).line().type("3");
    assertEquals(List.of("it/when: 'when' is needed: a condition"), problems(group));
    Map<String, Object> written = new LinkedHashMap<>();
    written.put("for", "1");
    written.put("when", "low");
    SettingNode other = node(new ValueType.Section(ALERT), written);
    other.nodes().get(0).line().type("");
    other.nodes().get(0).line().type("wrong");
    assertEquals("{for=1, when=wrong}", other.value().orElseThrow().toString());
    assertEquals(List.of("it/when: 'when' must be another one"), problems(other));
  }

  @Test
  void aValueHasTheShapeThatIsWrittenAndCanGetAnother() {
    ValueType trace = new ValueType.AnyOf(List.of(TEXT, new ValueType.Section(ALERT)));
    SettingNode traces = node(new ValueType.ListOf(trace), List.of("x", Map.of("when", "y")));
    assertInstanceOf(SettingShape.Line.class, traces.nodes().get(0).shape());
    assertInstanceOf(SettingShape.Group.class, traces.nodes().get(1).shape());
    traces.nodes().get(1).reshape(SettingShape.of(trace).getFirst());
    traces.nodes().get(1).line().type("z");
    assertEquals(List.of("x", "z"), traces.value().orElseThrow());
    ValueType texts = new ValueType.AnyOf(List.of(TEXT, new ValueType.ListOf(TEXT)));
    assertEquals(1, SettingShape.offered(texts).size(), "several texts are typed in one line");
    assertInstanceOf(SettingShape.Many.class, node(texts, List.of("scale(2, 1)")).shape(), "but for those with commas");
  }

  @Test
  void whatFollowsFromAnotherSettingFollowsItOnceItIsKnown() {
    ValueType size = new ValueType.Section(Schema.of(Setting.optional("size", NUMBER, "how long")));
    ValueType any = new ValueType.MapOf(TEXT);
    SettingNode layer = node(new ValueType.Section(Schema.of(Setting.optional("kind", TEXT, "which"),
        Setting.optional("with", new ValueType.Dependent("kind", Map.of("dots", size), any), "what it has"))),
        Map.of("kind", "other", "with", Map.of("size", "1", "more", "2")));
    SettingNode kind = layer.nodes().getFirst();
    assertInstanceOf(SettingShape.Many.class, layer.nodes().get(1).shape());
    kind.line().type("dot");
    assertFalse(layer.follow());
    kind.line().type("dots");
    assertTrue(layer.follow());
    assertFalse(layer.follow(), "it has");
    assertEquals(Map.of("kind", "dots", "with", Map.of("size", "1")), layer.value().orElseThrow());
    kind.line().type("");
    assertFalse(layer.follow());
    assertInstanceOf(SettingShape.Group.class, layer.nodes().get(1).shape());
  }

  @Test
  void whatMayBeTextOrNumberOrTruthIsTakenAsItLooks() {
    ValueType any = new ValueType.AnyOf(List.of(new ValueType.Flag(), NUMBER, TEXT));
    SettingNode node = node(any, null);
    node.line().type("true");
    assertEquals(Optional.of(true), node.value());
    node.line().type("2.5");
    assertEquals("2.5", node.value().orElseThrow().toString());
    node.line().type("red");
    assertEquals(Optional.of("red"), node.value());
  }
}
