package org.robotui.uic.tftree.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.robotui.uic.tftree.internal.model.Trees.NOW;
import static org.robotui.uic.tftree.internal.model.Trees.id;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.robotui.api.config.Schema;
import org.robotui.api.frame.FrameLink;
import org.robotui.api.port.InputState;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.testkit.FakeFrames;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.Health;
import org.robotui.ui.diagram.Box;
import org.robotui.ui.diagram.Diagram;

class TfTreeModelTest {
  private static final double STALE_AFTER = 3;

  private static TfTreeModel model(FakeFrames frames) {
    FakeUicContext context = new FakeUicContext("tftree", Schema.EMPTY);
    context.frames(frames);
    return new TfTreeModel(context);
  }

  private static TfTreeViewState look(FakeFrames frames, Ask ask) {
    TfTreeModel model = model(frames);
    model.ask(ask);
    model.tick(NOW, STALE_AFTER);
    return model.look();
  }

  private static List<String> names(TfTreeViewState look) {
    return look.rows().stream().map(row -> row.depth() + " " + row.title()).toList();
  }

  @Test
  void withoutFramesItSaysWhatItWaitsFor() {
    assertInstanceOf(InputState.Waiting.class, look(new FakeFrames(), Ask.FIRST).state());
  }

  @Test
  void eachFrameFollowsTheOneThatCarriesIt() {
    TfTreeViewState look = look(Trees.frames(Trees.base()), Ask.FIRST);
    assertEquals(List.of("0 map", "1 odom", "2 base_footprint", "3 base_link", "4 camera_link", "5 camera_color_frame",
        "6 camera_color_optical_frame", "5 camera_depth_frame", "6 camera_depth_optical_frame", "4 imu_link", "4 laser",
        "4 wheel_left_link",
        "4 wheel_right_link"), names(look));
    assertEquals("13 frames", look.title());
    assertEquals(List.of(), look.notices());
    assertEquals("root of 12 frames", look.rows().getFirst().note());
    assertEquals("10.0\u00a0Hz \u00b7 40\u00a0ms", look.rows().get(1).note());
    assertEquals("static", look.rows().get(3).note());
  }

  @Test
  void whatIsWrongIsSaidTheWorstFirst() {
    TfTreeViewState look = look(Trees.frames(Trees.faulty(), Trees.refusal()), Ask.FIRST);
    assertEquals(List.of(Health.BAD, Health.BAD, Health.STALE, Health.WARNING),
        look.notices().stream().map(Notice::health).toList());
    assertTrue(look.notices().get(0).words().contains("would close a loop")
        && look.notices().get(0).words().contains("12 times"));
    assertTrue(look.notices().get(1).words().contains("base_footprint"));
    assertTrue(look.notices().get(2).words().contains("odom"));
    assertEquals("The frames of Keira are 2 trees, no transform links map, world", look.notices().get(3).words());
    assertEquals(List.of("0 map", "1 odom", "2 base_footprint"),
        names(look(Trees.frames(Trees.faulty()), Ask.FIRST.problems(true))), "with those above them");
  }

  @Test
  void severalRobotsAreNoFaultButNotLinked() {
    FakeFrames frames = Trees.frames(Trees.base());
    frames.known(List.of(), List.of());
    FrameId other = new FrameId("Natalie", "map");
    frames.fix(other, new FrameId("Natalie", "odom"), RigidTransform.IDENTITY);
    FrameLink link =
        new FrameLink(other, new FrameId("Natalie", "odom"), true, Optional.empty(), 0, 1, "", 0, 0, List.of());
    List<FrameLink> links = new ArrayList<>(Trees.base());
    links.add(link);
    frames.known(links, List.of());
    TfTreeViewState look = look(frames, Ask.FIRST);
    assertEquals(List.of(Health.NONE), look.notices().stream().map(Notice::health).toList());
    assertTrue(names(look).contains("0 Natalie:map"), names(look).toString());
    assertEquals("15 frames, 2 trees", look.title());
  }

  @Test
  void whatIsFoldedIsHiddenUnlessItIsSearched() {
    Ask folded = Ask.FIRST.toggle(id("base_link"));
    TfTreeViewState look = look(Trees.frames(Trees.base()), folded);
    assertEquals(List.of("0 map", "1 odom", "2 base_footprint", "3 base_link"), names(look));
    assertTrue(look.rows().getLast().note().contains("+9"));
    assertEquals(
        List.of("0 map", "1 odom", "2 base_footprint", "3 base_link", "4 camera_link", "5 camera_depth_frame",
            "6 camera_depth_optical_frame"),
        names(look(Trees.frames(Trees.base()), folded.search("DEPTH optical"))));
    assertEquals(List.of(), names(look(Trees.frames(Trees.base()), Ask.FIRST.search("nothing"))));
  }

  @Test
  void thePoseIsShownInTheChosenFrame() {
    FakeFrames frames = Trees
        .frames(List.of(Trees.fixed("base", "mount"), Trees.fixed("mount", "laser"), Trees.fixed("world", "marker")));
    FrameDetail root = look(frames, Ask.FIRST.select(Optional.of(id("laser")))).detail().orElseThrow();
    assertEquals(id("base"), root.reference());
    FrameDetail parent =
        look(frames, Ask.FIRST.select(Optional.of(id("laser"))).in(new Ask.Reference.Parent())).detail().orElseThrow();
    assertEquals(id("mount"), parent.reference());
    assertEquals(new FrameDetail.Value("x", "1.000\u00a0m"), parent.values().getFirst());
    assertTrue(parent.text().contains("yaw\t17.19\u00b0"), parent.text());
    FrameDetail apart =
        look(frames, Ask.FIRST.select(Optional.of(id("laser"))).in(new Ask.Reference.Pinned(id("marker")))).detail()
            .orElseThrow();
    assertTrue(apart.missing().orElseThrow().contains("is missing"), apart.missing().toString());
  }

  @Test
  void aTickWithoutNewsChangesNothing() {
    TfTreeModel model = model(Trees.frames(Trees.base()));
    assertTrue(model.tick(NOW, STALE_AFTER));
    Diagram drawing = model.look().drawing();
    assertFalse(model.tick(NOW + 100_000_000L, STALE_AFTER));
    assertFalse(model.tick(NOW + 499_000_000L, STALE_AFTER));
    assertSame(drawing, model.look().drawing());
    assertTrue(model.tick(NOW + 500_000_000L, STALE_AFTER), "ages");
  }

  @Test
  void linksReadWhileAFrameMovedDoNotHangIt() {
    Forest forest = Forest.of(List.of(), List.of(Trees.fixed("a", "b"), Trees.fixed("b", "a"), Trees.fixed("a", "c")));
    assertEquals(List.of(), forest.roots());
    assertEquals(List.of(), forest.inOrder());
    assertTrue(Set.of(id("a"), id("b")).contains(forest.root(id("c"))));
  }

  @Test
  void noBoxCoversAnotherInALargeTreeAndAllAreDrawnOnce() {
    TfTreeViewState look = look(Trees.frames(Trees.many(3000)), Ask.FIRST);
    Diagram drawing = look.drawing();
    assertEquals(3001, drawing.boxes().size());
    assertEquals(3000, drawing.wires().size());
    Set<List<Long>> places = new HashSet<>();
    for (Box box : drawing.boxes()) {
      assertTrue(places.add(List.of(Math.round(box.x()), Math.round(box.y()))), box.title());
      assertTrue(box.x() >= 0 && box.y() >= 0 && box.x() + box.width() <= drawing.width() + 1
          && box.y() + box.height() <= drawing.height() + 1);
    }
  }
}
