package org.robotui.uic.trip.internal;

import java.util.Optional;
import org.robotui.api.port.SourceId;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.Odometry;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.FakeUicContext;

/** Robots that are somewhere, for tests. */
final class TripPoses {

  private TripPoses() {}

  static void at(FakeUicContext context, String port, double x, double y) {
    Odometry odometry =
        new Odometry(new FrameId("Keira", "odom"), new FrameId("Keira", "base"), RigidTransform.planar(x, y, 0),
            Doubles.EMPTY, Vector3.ZERO, Vector3.ZERO, Doubles.EMPTY);
    context.input(TripType.ODOMETRY).put(new SourceId("base", port), odometry, System.nanoTime(), Optional.empty());
  }
}
