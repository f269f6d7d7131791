package org.robotui.api.layout;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.robotui.api.layout.Arrangement.Added;
import org.robotui.api.layout.Layout.Direction;
import org.robotui.api.layout.Layout.Split;
import org.robotui.api.layout.Layout.Tabs;
import org.robotui.api.layout.Layout.View;

class ArrangementTest {
  private static final Layout WRITTEN = new Split(Direction.ROW,
      List.of(new Tabs(List.of("map", "scene")), new View("camera")), List.of(3.0, 1.0));
  private static final Arrangement START = new Arrangement(WRITTEN);
  private static final WindowBounds PLACE = new WindowBounds(2000, 50, 400, 300);

  private static Arrangement moved(String view, DropTarget target) {
    return START.with(view, target);
  }

  @Test
  void aViewJoinsTheTabsOfAnother() {
    assertEquals(new Tabs(List.of("map", "camera", "scene"), 1),
        moved("camera", new DropTarget.Tab("scene", 1)).layout());
  }

  @Test
  void aViewLiesBesideAnotherWithHalfOfItsRoom() {
    assertEquals(
        new Split(Direction.ROW,
            List.of(new Tabs(List.of("map")),
                new Split(Direction.COLUMN, List.of(new View("scene"), new View("camera")),
                    List.of(0.5, 0.5))),
            List.of(3.0, 1.0)),
        moved("scene", new DropTarget.Side("camera", Edge.TOP)).layout());
  }

  @Test
  void aRowWithinARowIsOneRow() {
    assertEquals(new Split(Direction.ROW, List.of(new Tabs(List.of("map")), new View("camera"), new View("scene")),
        List.of(3.0, 0.5, 0.5)), moved("scene", new DropTarget.Side("camera", Edge.RIGHT)).layout());
  }

  @Test
  void aViewLiesAlongAWholeSide() {
    Split whole = (Split) moved("scene", new DropTarget.Border(0, Edge.BOTTOM)).layout();
    assertEquals(Direction.COLUMN, whole.direction());
    assertEquals(new View("scene"), whole.parts().getLast());
  }

  @Test
  void theLastViewOfASplitTakesItsRoom() {
    assertEquals(new Tabs(List.of("map", "scene")), START.without("camera").layout());
  }

  @Test
  void aViewHasAWindowOfItsOwnAndComesBack() {
    Arrangement own = moved("camera", new DropTarget.OwnWindow(PLACE));
    assertEquals(new View("camera"), own.layout(1));
    assertEquals(List.of("map", "scene", "camera"), own.views());
    Arrangement back = own.with("camera", new DropTarget.Side("map", Edge.RIGHT));
    assertEquals(List.of(), back.windows());
    assertEquals(List.of("map", "scene", "camera"), back.views());
  }

  @Test
  void aMainWindowWithoutViewsTakesOne() {
    Arrangement empty = START.without("map").without("scene").without("camera");
    assertEquals(new Tabs(List.of()), empty.layout());
    assertEquals(new View("map"), empty.with("map", new DropTarget.Border(0, Edge.LEFT)).layout());
  }

  @Test
  void aLoneViewStaysWhereItLies() {
    Arrangement own = moved("camera", new DropTarget.OwnWindow(PLACE));
    assertSame(own, own.with("camera", new DropTarget.Border(1, Edge.LEFT)));
    assertSame(START, moved("camera", new DropTarget.Side("camera", Edge.LEFT)));
    assertSame(START, moved("camera", new DropTarget.Tab("nobody", 0)));
    assertSame(START, moved("camera", new DropTarget.Border(5, Edge.LEFT)));
  }

  @Test
  void theNextTabComesToTheFront() {
    Arrangement front = START.fronted("scene");
    assertEquals(new Tabs(List.of("map", "scene"), 1), front.without("camera").layout());
    assertEquals(new Tabs(List.of("map"), 0), front.without("camera").without("scene").layout());
    assertThrows(IllegalArgumentException.class, () -> new Tabs(List.of("map"), 1));
  }

  @Test
  void aTabThatIsInFrontIsNoOtherPlace() {
    assertTrue(START.liesAs(START.fronted("scene")));
    assertFalse(START.liesAs(START.without("scene")));
    assertFalse(START.liesAs(START.weighted(0, List.of(), List.of(1.0, 1.0))));
  }

  @Test
  void sharesAreThoseOfOneSplit() {
    Arrangement nested = moved("scene", new DropTarget.Side("camera", Edge.TOP));
    Split whole = (Split) nested.weighted(0, List.of(1), List.of(1.0, 9.0)).layout();
    assertEquals(List.of(3.0, 1.0), whole.weights());
    assertEquals(List.of(1.0, 9.0), ((Split) whole.parts().getLast()).weights());
    assertEquals(nested, nested.weighted(0, List.of(7), List.of(1.0, 9.0)));
    assertEquals(nested, nested.weighted(0, List.of(), List.of(1.0, 9.0, 3.0)));
  }

  @Test
  void whatIsUnknownIsLeftOut() {
    Arrangement more = START.adding(new Added("plot-2", "plot")).with("plot-2", new DropTarget.Tab("map", 9))
        .adding(new Added("x", "x"));
    assertEquals(List.of(new Added("plot-2", "plot")), more.only(Set.of("map", "plot-2")).added());
    assertEquals(List.of("map", "plot-2"), more.only(Set.of("map", "plot-2")).views());
  }

  @Test
  void aViewHasOnePlace() {
    assertThrows(IllegalArgumentException.class, () -> new Arrangement(new Tabs(List.of("map", "map"))));
  }

  /** Whatever a user does, no view is lost or doubled, and what is written can be read again. */
  @Test
  void noViewIsEverLostByMoving() {
    Random random = new Random(7);
    List<String> all = new ArrayList<>(START.views());
    Arrangement now = START;
    for (int i = 0; i < 5000; i++) {
      String view = all.get(random.nextInt(all.size()));
      if (i % 500 == 499 && all.size() < 12) {
        all.add("plot-" + i);
        now = now.adding(new Added("plot-" + i, "plot"));
        view = all.getLast();
      }
      Arrangement before = now;
      now = now.with(view, target(random, all, now));
      Set<String> expected = new HashSet<>(before.views());
      expected.add(view);
      assertTrue(now.views().size() == new HashSet<>(now.views()).size());
      assertTrue(now == before || new HashSet<>(now.views()).equals(expected), view + " in " + now);
      assertTrue(LayoutChange.depth(now.layout()) <= 30);
    }
  }

  private static DropTarget target(Random random, List<String> all, Arrangement now) {
    String other = all.get(random.nextInt(all.size()));
    Edge edge = Edge.values()[random.nextInt(4)];
    return switch (random.nextInt(10)) {
      case 0 -> new DropTarget.OwnWindow(new WindowBounds(random.nextInt(100) - 50, 0, 1, 1));
      case 1, 2 -> new DropTarget.Border(random.nextInt(now.windows().size() + 2), edge);
      case 3, 4, 5 -> new DropTarget.Tab(other, random.nextInt(5));
      default -> new DropTarget.Side(other, edge);
    };
  }
}
