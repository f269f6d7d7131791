package org.robotui.uic.scene3d.internal.waypoint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;

class RouteTextTest {
  private static final FrameId MAP = new FrameId("a", "map");
  private static final Route ROUTE = new Route(Optional.of(new FrameId("b", "odom")),
      List.of(RigidTransform.planar(1, -2.5, 0.5), RigidTransform.planar(1234.5678, 0, -3)));

  private static RouteText.Outcome.Read read(String file, String text) {
    return assertInstanceOf(RouteText.Outcome.Read.class, RouteText.read(file, text));
  }

  private static void near(Route expected, Route actual) {
    assertEquals(expected.frame(), actual.frame());
    assertEquals(expected.poses().size(), actual.poses().size());
    for (int i = 0; i < expected.poses().size(); i++) {
      RigidTransform off = expected.poses().get(i).inverse().times(actual.poses().get(i));
      assertTrue(off.translation().norm() < 1e-3 && Math.abs(off.rotation().yaw()) < 1e-3, "waypoint " + i);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"way.yaml", "way.yml", "way", "way.csv", "WAY.CSV"})
  void whatIsWrittenIsRead(String file) {
    near(ROUTE, read(file, RouteText.write(file, ROUTE)).route(MAP));
    near(Route.NONE, read(file, RouteText.write(file, Route.NONE)).route(MAP));
  }

  @Test
  void columnsMayStandInAnyOrderAndFramesWithoutRobotAreThoseOfTheFixedOne() {
    Route route = read("a.csv", "# mine\n\n# frame: odom\nyaw; y; x\n0.5;-2.5;1\n").route(MAP);
    near(new Route(Optional.of(new FrameId("a", "odom")), List.of(RigidTransform.planar(1, -2.5, 0.5))), route);
    near(new Route(Optional.of(MAP), List.of(RigidTransform.planar(3, 0, 0))),
        read("a.yaml", "waypoints: [{x: 3}]").route(MAP));
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', textBlock = """
      a.csv  | 1,2,3                       | line 1: the first line names the columns
      a.csv  | x,y,x~1,2,3                 | line 1: the first line names the columns
      a.csv  | x,y~1,2,3                   | line 2: there are 3 values and 2 columns
      a.csv  | x,y~1,NaN                   | line 2: 'NaN' is no y: a number of metres is expected
      a.csv  | x,y,yaw~1,2,north           | line 2: 'north' is no yaw: a number of radians is expected
      a.yaml | 'waypoints:~- {x: far}'     | line 2: 'far' is no x
      a.yaml | 'waypoints:~- {x: 1e300}'   | line 2: '1e300' is no x
      a.yaml | 'waypoints:~- {lat: 1}'     | line 2: 'lat' is no part of a waypoint
      a.yaml | 'points: []'                | line 1: 'points' is not known here: write waypoint_frame or waypoints
      a.yaml | 'waypoints: 3'              | line 1: a list of waypoints is expected
      a.yaml | '- {x: 1}'                  | line 1: waypoints is expected here
      a.yaml | 'waypoints: [{x: 1}'        | line 1: this is no YAML
      a.yaml | 'waypoints: !!java.net.URL [a]' | line 1: this is no YAML: Global tag
      a.yaml | ''                          | line 1: it is empty
      """)
  void faultsAreNamedWithTheirLine(String file, String text, String why) {
    RouteText.Outcome outcome = RouteText.read(file, text == null ? "" : text.replace('~', '\n'));
    String said = assertInstanceOf(RouteText.Outcome.Unreadable.class, outcome).why();
    assertTrue(said.startsWith(why), said);
  }

  @Test
  void tooManyAreRefused() {
    String text = "x,y\n" + "1,2\n".repeat(Route.MOST + 1);
    assertTrue(assertInstanceOf(RouteText.Outcome.Unreadable.class, RouteText.read("a.csv", text)).why()
        .contains("more than 500"));
    assertEquals(Route.MOST, read("a.csv", text.substring(0, text.length() - 4)).poses().size());
    assertTrue(
        assertInstanceOf(RouteText.Outcome.Unreadable.class, RouteText.read("a.csv", " ".repeat(RouteText.MOST + 1)))
            .why().contains("larger"));
    String aliases = "a: &a [x,x,x,x,x,x,x,x]\nb: &b [*a,*a,*a,*a,*a,*a]\nwaypoints: [*b,*b]";
    assertInstanceOf(RouteText.Outcome.Unreadable.class, RouteText.read("a.yaml", aliases));
  }

  @Test
  void damagedFilesAreReadOrRefusedAndNothingElse() {
    SplittableRandom random = new SplittableRandom(7);
    for (String file : List.of("a.yaml", "a.csv")) {
      for (int i = 0; i < 3000; i++) {
        StringBuilder text = new StringBuilder(RouteText.write(file, ROUTE));
        for (int changes = random.nextInt(1, 6); changes > 0; changes--) {
          text.setCharAt(random.nextInt(text.length()), (char) random.nextInt(1, 256));
        }
        if (RouteText.read(file, text.toString()) instanceof RouteText.Outcome.Read read) {
          assertTrue(read.route(MAP).poses().stream()
              .allMatch(pose -> Double.isFinite(pose.translation().norm() + pose.rotation().yaw())), text::toString);
        }
      }
    }
  }
}
