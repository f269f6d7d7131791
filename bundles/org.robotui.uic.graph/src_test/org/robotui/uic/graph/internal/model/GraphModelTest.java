package org.robotui.uic.graph.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.Input.Candidate;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.geometry.Wrench;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.diagram.Box;
import org.robotui.ui.diagram.Diagram;
import org.robotui.ui.diagram.Wire;
import org.robotui.uic.graph.internal.GraphOptions;
import org.robotui.uic.graph.internal.GraphPorts;

class GraphModelTest {
  private static final GraphOptions OPTIONS = new GraphOptions(2_000_000_000L, 20, 120);
  private static final long SECOND = 1_000_000_000L;

  private final FakeUicContext context = new FakeUicContext("graph", GraphOptions.schema());
  private long now = 50 * SECOND;

  private GraphModel model(Robots robot) {
    context.robots(List.of(robot.robot("base")));
    return new GraphModel(context);
  }

  private GraphViewState look(GraphModel model, Ask ask) {
    model.ask(ask);
    for (int i = 0; i < 3; i++) {
      now += 3 * SECOND;
      model.seen(now);
      model.tick(now, OPTIONS);
    }
    return model.look();
  }

  private GraphViewState look(Robots robot, UnaryOperator<Ask> wanted) {
    return look(model(robot), wanted.apply(Ask.FIRST));
  }

  private static Vertex topic(String name) {
    return new Vertex(Vertex.Kind.TOPIC, "base", name);
  }

  private static Vertex node(String name) {
    return new Vertex(Vertex.Kind.NODE, "base", name);
  }

  private static Vertex group(String name) {
    return new Vertex(Vertex.Kind.GROUP, "base", name);
  }

  private static Set<String> names(GraphViewState look, Box.Form form) {
    return look.diagram().boxes().stream().filter(box -> box.form() == form).map(box -> ((Vertex) box.key()).name())
        .collect(Collectors.toSet());
  }

  @Test
  void manyTopicsThatAreWiredAlikeShareABoxUntilItIsOpened() {
    Robots robot = new Robots();
    for (int i = 0; i < 30; i++) {
      robot.tie("/driver > /sensor" + i % 3 + "/topic" + i);
    }
    robot.tie("/driver < /cmd_vel", "/teleop > /cmd_vel");
    Ask all = Ask.FIRST.show(true, true, true, false, true);
    GraphViewState folded = look(robot, ask -> all);
    Vertex fold = group("topics of /driver");
    Box box = folded.diagram().find(fold).orElseThrow();
    assertEquals("30 inside", box.note());
    assertEquals(Set.of("/cmd_vel"), names(folded, Box.Form.PILL));
    GraphViewState opened = look(robot, ask -> all.open(fold, true));
    assertEquals(31, names(opened, Box.Form.PILL).size());
    assertEquals(Box.Form.GROUP, opened.diagram().find(fold).orElseThrow().form(), "a frame, to close it again");
  }

  @Test
  void withoutARobotItSaysWhatIsMissing() {
    GraphModel model = new GraphModel(context);
    assertInstanceOf(InputState.Unconnected.class, look(model, Ask.FIRST).state());
  }

  @Test
  void toolsTransformsAndDeadEndsAreLeftOut() {
    GraphViewState look = look(Robots.base(), ask -> ask);
    assertEquals(Set.of("/laser/driver", "/base/driver", "/amcl", "/map_server", "/move_base", "/mission",
        "/camera/driver", "/camera/rectify",
        "/detector"), names(look, Box.Form.ROUNDED));
    assertTrue(names(look, Box.Form.PILL).containsAll(Set.of("/scan", "/move_base/goal", "/camera/image_rect")));
    assertFalse(
        names(look, Box.Form.PILL).contains("/tf") || names(look, Box.Form.PILL).contains("/move_base/unheard"));
    GraphViewState all = look(Robots.base(), ask -> ask.show(true, false, false, false, true));
    assertTrue(names(all, Box.Form.PILL).containsAll(Set.of("/tf", "/rosout", "/move_base/unheard")));
    assertTrue(names(all, Box.Form.ROUNDED).contains("/robotui_77"));
  }

  @Test
  void deadEndsStayWhereNothingElseIsLeft() {
    assertEquals(Set.of("/odom", "/cmd_vel"),
        names(look(new Robots().tie("/robot > /odom", "/robot < /cmd_vel"), ask -> ask), Box.Form.PILL));
  }

  @Test
  void aNodeLiesInTheNamespaceOfItsName() {
    GraphViewState look = look(Robots.base(), ask -> ask);
    assertEquals(Set.of("/camera", "/move_base"), names(look, Box.Form.GROUP));
    Box frame = look.diagram().find(group("/move_base")).orElseThrow();
    Box inside = look.diagram().find(node("/move_base")).orElseThrow();
    assertTrue(frame.contains(inside.x(), inside.y())
        && frame.contains(inside.x() + inside.width() - 1, inside.y() + inside.height() - 1));
    assertEquals("goal", look.diagram().find(topic("/move_base/goal")).orElseThrow().title());
  }

  @Test
  void wiresBeginAndEndAtTheirBoxes() {
    Diagram diagram = look(Robots.base(), ask -> ask).diagram();
    assertFalse(diagram.wires().isEmpty());
    for (Wire wire : diagram.wires()) {
      assertTouches(diagram.find(wire.from()).orElseThrow(), wire.corners().getFirst());
      assertTouches(diagram.find(wire.to()).orElseThrow(), wire.corners().getLast());
    }
  }

  private static void assertTouches(Box box, Wire.Corner at) {
    assertTrue(
        at.x() >= box.x() - 2 && at.x() <= box.x() + box.width() + 2 && at.y() >= box.y() - 2
            && at.y() <= box.y() + box.height() + 2,
        box + " " + at);
  }

  @Test
  void withNodesOnlyTopicsAreWires() {
    GraphViewState look = look(Robots.base(), ask -> ask.show(false, true, true, true, false));
    assertEquals(Set.of(), names(look, Box.Form.PILL));
    assertTrue(look.diagram().wires().stream()
        .anyMatch(wire -> wire.from().equals(node("/laser/driver")) && wire.to().equals(node("/amcl"))
            && wire.label().equals("/scan")));
  }

  @Test
  void aFilterKeepsWhatIsWiredToWhatItFinds() {
    GraphViewState look = look(Robots.base(), ask -> ask.search("detector"));
    assertEquals(Set.of("/detector", "/camera/rectify", "/mission"), names(look, Box.Form.ROUNDED));
    GraphViewState none = look(Robots.base(), ask -> ask.search("nonsense"));
    assertEquals("No match", none.empty().orElseThrow().title());
  }

  @Test
  void aLargeGraphIsClosedByNamespaceUntilItIsOpened() {
    GraphViewState look = look(Robots.many(200, 2000), ask -> ask);
    assertEquals(20, look.diagram().boxes().size());
    assertEquals("200 nodes, 2000 topics", look.title());
    GraphViewState opened = look(Robots.many(200, 2000), ask -> ask.open(group("/part3"), true));
    assertEquals(19 + 1 + 110, opened.diagram().boxes().size(), "the frame, ten nodes and a hundred topics");
    GraphViewState closed = look(Robots.base(), ask -> ask.open(group("/camera"), false));
    Box box = closed.diagram().find(group("/camera")).orElseThrow();
    assertEquals(Box.Form.ROUNDED, box.form());
    assertEquals("5 inside", box.note());
  }

  @Test
  void moreThanCanBeLaidOutIsSaidAndNotTried() {
    Robots flat = new Robots();
    for (int i = 0; i < 1300; i++) {
      flat.tie("/n" + i + " > /t" + i, "/m < /t" + i);
    }
    GraphViewState look = look(flat, ask -> ask);
    assertEquals("Too many boxes to draw", look.empty().orElseThrow().title());
    assertEquals(0, look.diagram().boxes().size());
  }

  @Test
  void aNewNodeLeavesTheOthersInTheirOrder() {
    Robots robot = Robots.base();
    GraphModel model = model(robot);
    Diagram before = look(model, Ask.FIRST).diagram();
    robot.tie("/recorder2 < /odom", "/recorder2 < /scan", "/recorder2 > /recorded", "/mission < /recorded");
    Diagram after = look(model, Ask.FIRST).diagram();
    assertTrue(after.find(node("/recorder2")).isPresent());
    Map<Long, List<Object>> columns = columns(before);
    int kept = 0;
    for (List<Object> column : columns.values()) {
      for (int i = 0; i + 1 < column.size(); i++) {
        Box upper = after.find(column.get(i)).orElseThrow();
        Box lower = after.find(column.get(i + 1)).orElseThrow();
        boolean sameColumn = Math.abs(upper.x() + upper.width() / 2 - lower.x() - lower.width() / 2) < 5;
        assertTrue(!sameColumn || upper.y() < lower.y(), upper.title() + " and " + lower.title() + " changed places");
        kept += sameColumn ? 1 : 0;
      }
    }
    assertTrue(kept > 0);
  }

  private static Map<Long, List<Object>> columns(Diagram diagram) {
    Map<Long, List<Object>> columns = new HashMap<>();
    diagram.boxes().stream().filter(box -> box.form() != Box.Form.GROUP).sorted(Comparator.comparingDouble(Box::y))
        .forEach(box -> columns.computeIfAbsent(Math.round(box.x() + box.width() / 2), x -> new ArrayList<>())
            .add(box.key()));
    return columns;
  }

  @Test
  void whileANewLayoutIsMadeTheOneBeforeStays() {
    Robots robot = Robots.base();
    GraphModel model = model(robot);
    Diagram before = look(model, Ask.FIRST).diagram();
    Deque<Runnable> tasks = new ArrayDeque<>();
    context.background(tasks::add);
    GraphModel slow = model(robot);
    slow.seen(now);
    slow.tick(now, OPTIONS);
    tasks.pop().run();
    slow.tick(now, OPTIONS);
    assertTrue(slow.look().laying());
    while (!tasks.isEmpty()) {
      tasks.pop().run();
    }
    slow.tick(now, OPTIONS);
    assertFalse(slow.look().laying());
    Diagram laid = slow.look().diagram();
    assertEquals(before.boxes().size(), laid.boxes().size());
    slow.ask(Ask.FIRST.search("camera"));
    slow.tick(now, OPTIONS);
    assertSame(laid, slow.look().diagram());
  }

  @Test
  void onlyWhatIsLookedAtIsMeasured() {
    Robots robot = Robots.base();
    GraphModel model = model(robot);
    FakeInput<Data> input = context.input(GraphPorts.ALL);
    SourceId scan = new SourceId("base", "/scan");
    input.candidates(
        List.of(new Candidate(scan, "LaserScan"), new Candidate(new SourceId("base", "/odom"), "Odometry")));
    assertEquals(Set.of(), input.chosen());
    look(model, Ask.FIRST.select(Optional.of(topic("/scan"))));
    assertEquals(Set.of(), input.chosen(), "not asked for");
    look(model, Ask.FIRST.select(Optional.of(topic("/scan"))).measure(true));
    assertEquals(Set.of(scan), input.chosen());
    for (int i = 0; i < 11; i++) {
      input.put(scan, new Wrench(new FrameId("Keira", "f"), Vector3.ZERO,
          Vector3.ZERO), now + i * 100_000_000L, Optional.empty());
    }
    now += SECOND;
    model.seen(now);
    model.tick(now, OPTIONS);
    model.tick(now + SECOND, OPTIONS);
    assertTrue(model.look().selected().contains("10.0\u00a0Hz"), model.look().selected());
    assertTrue(model.look().diagram().wires().stream().anyMatch(wire -> wire.label().contains("10.0\u00a0Hz")));
    look(model, Ask.FIRST);
    assertEquals(Set.of(), input.chosen());
  }

  @Test
  void whileNothingIsSelectedAllThatIsDrawnIsMeasured() {
    GraphModel model = model(Robots.base());
    FakeInput<Data> input = context.input(GraphPorts.ALL);
    SourceId scan = new SourceId("base", "/scan");
    SourceId odom = new SourceId("base", "/odom");
    input.candidates(List.of(new Candidate(scan, "LaserScan"), new Candidate(odom, "Odometry")));
    look(model, Ask.FIRST.measure(true));
    assertEquals(Set.of(scan, odom), input.chosen());
    look(model, Ask.FIRST.measure(true).search("scan"));
    assertEquals(Set.of(scan), input.chosen(), "what is filtered away is not asked for");
  }

  @Test
  void aRobotThatFallsSilentKeepsItsGraphWithTheReason() {
    Robots robot = Robots.base();
    GraphModel model = model(robot);
    look(model, Ask.FIRST);
    robot.fail("the master does not answer");
    GraphViewState look = look(model, Ask.FIRST);
    assertFalse(look.diagram().boxes().isEmpty());
    assertEquals(Optional.of("base does not answer: the master does not answer"), look.notice());
  }

  @Test
  void severalRobotsHaveAFrameEach() {
    context.robots(List.of(Robots.base().robot("one"), Robots.base().robot("two")));
    GraphViewState look = look(new GraphModel(context), Ask.FIRST);
    assertTrue(look.diagram().find(new Vertex(Vertex.Kind.GROUP, "one", "")).isPresent());
    assertTrue(look.diagram().find(new Vertex(Vertex.Kind.GROUP, "two", "/camera")).isPresent());
  }
}
