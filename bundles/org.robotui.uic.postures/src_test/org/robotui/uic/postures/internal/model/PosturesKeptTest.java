package org.robotui.uic.postures.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.Schema;
import org.robotui.testkit.FakeSettings;
import org.robotui.uic.postures.internal.model.PostureText.Content;

class PosturesKeptTest {
  private static final PostureSequence TWO = new PostureSequence(List.of(
      new Posture("up \"high\" \\ \u00e4", 2.5, joints(0.25, -1.5)), new Posture("down", 3, joints(0, 0))));

  private static Map<String, Double> joints(double shoulder, double elbow) {
    Map<String, Double> joints = new LinkedHashMap<>();
    joints.put("shoulder", shoulder);
    joints.put("elbow", elbow);
    return joints;
  }

  @Test
  void settingsGiveBackWhatTheyWereGiven() {
    FakeSettings settings = new FakeSettings(Schema.of(PostureSequence.setting()));
    assertEquals(PostureSequence.NONE, PostureSequence.read(settings.current()));
    TWO.write(settings);
    assertEquals(TWO, PostureSequence.read(settings.current()));
  }

  @Test
  void filesDoSoToo() {
    String text = PostureText.write(TWO);
    assertTrue(text.contains("joints: {\"shoulder\": 0.25, \"elbow\": -1.5}"), text);
    assertEquals(TWO, assertInstanceOf(Content.Postures.class, PostureText.read(text)).sequence());
    assertEquals(PostureSequence.NONE,
        assertInstanceOf(Content.Postures.class, PostureText.read(PostureText.write(PostureSequence.NONE))).sequence());
  }

  @Test
  void whatIsWrongInAFileIsSaidWithItsLine() {
    assertEquals("line 1: 'poses' is not known here: write `postures`", why("poses: []"));
    assertEquals("line 2: a posture needs `name` and `joints`", why("postures:\n  - {name: a}"));
    assertEquals("line 2: 'nan' is no number from -1000000 to 1000000",
        why("postures:\n  - {name: a, joints: {x: nan}}"));
    assertEquals("line 2: '0' is no number from 0.1 to 3600",
        why("postures:\n  - {name: a, seconds: 0, joints: {x: 1}}"));
    assertEquals("line 2: 'angles' is no part of a posture: name, seconds and joints are",
        why("postures:\n  - {name: a, angles: {x: 1}}"));
    assertTrue(why("postures: [").startsWith("line 1: this is no YAML: "));
    assertEquals("it is empty: a list `postures` is expected", why(""));
    assertTrue(why("[".repeat(100)).contains("this is no YAML"));
  }

  private static String why(String text) {
    return assertInstanceOf(Content.Unreadable.class, PostureText.read(text)).why();
  }

  @Test
  void aFreshNameIsNobodysName() {
    PostureSequence named = TWO.with(0, TWO.postures().getFirst().named("Posture 3"));
    assertEquals("Posture 4", named.freshName());
    assertEquals("down", TWO.moved(1, -1).postures().getFirst().name());
    assertEquals(TWO, TWO.moved(0, -1));
  }

  @Test
  void manyJointsAreToldInOrdersThatAPluginTakes() {
    Map<String, Double> many = IntStream.range(0, 60).boxed()
        .collect(Collectors.toMap(i -> "left_arm_joint_number_" + i, i -> i / 7.0));
    List<String> orders = LegOrders.of(17, many, 2, 0.5);
    assertTrue(orders.size() > 3);
    assertTrue(orders.stream().allMatch(order -> order.startsWith("@17 ") && order.length() < 490), orders::toString);
    String all = orders.stream().map(order -> order.substring("@17 ".length())).collect(Collectors.joining(";"));
    assertEquals(60, all.split("left_arm_joint_number_").length - 1);
    assertTrue(all.startsWith("begin;joints ") && all.endsWith(";velocity 0.5;run"), all);
  }
}
