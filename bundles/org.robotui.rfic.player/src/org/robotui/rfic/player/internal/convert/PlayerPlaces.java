package org.robotui.rfic.player.internal.convert;

import java.util.Comparator;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.Path;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.player.interfaces.Fiducial;
import org.robotui.player.interfaces.Localize;
import org.robotui.player.interfaces.Planner;

/** Where localisation believes the robot to be, and ways. */
public final class PlayerPlaces {
  private static final int XX = 0;
  private static final int YY = 1;
  private static final int AA = 2;
  private static final int XY = 3;
  private static final int YA = 4;
  private static final int XA = 5;
  private static final int AXES = 6;
  private static final int YAW = 5;

  private PlayerPlaces() {}

  /** The most likely guess; none where there is none. */
  public static Optional<PoseEstimate> estimate(Localize.Hypotheses m, FrameId map) {
    return m.hypotheses().stream().max(Comparator.comparingDouble(Localize.Hypothesis::weight))
        .map(best -> new PoseEstimate(map, Poses.of(best.mean()), covariance(best.covariance())));
  }

  public static PoseArray guesses(Localize.Hypotheses m, FrameId map) {
    return new PoseArray(map, m.hypotheses().stream().map(h -> Poses.of(h.mean())).toList());
  }

  public static PoseArray particles(Localize.Particles m, FrameId map) {
    return new PoseArray(map, m.particles().stream().map(p -> Poses.of(p.pose())).toList());
  }

  public static PoseArray markers(Fiducial.Scan m, FrameId frame) {
    return new PoseArray(frame, m.markers().stream().map(marker -> Poses.of(marker.pose())).toList());
  }

  public static Path way(Planner.Waypoints m, FrameId map) {
    return new Path(map, m.waypoints().stream().map(Poses::of).toList());
  }

  public static Localize.Estimate estimate(PoseEstimate said) {
    double[] c = new double[AXES];
    Doubles given = said.covariance();
    if (given.size() > 0) {
      c[XX] = given.get(0);
      c[YY] = given.get(at(1, 1));
      c[AA] = given.get(at(YAW, YAW));
      c[XY] = given.get(at(0, 1));
      c[YA] = given.get(at(1, YAW));
      c[XA] = given.get(at(0, YAW));
    }
    return new Localize.Estimate(Poses.planar(said.pose()), c);
  }

  private static Doubles covariance(double[] c) {
    double[] full = new double[Odometry.COVARIANCE_SIZE];
    full[0] = c[XX];
    full[at(1, 1)] = c[YY];
    full[at(YAW, YAW)] = c[AA];
    full[at(0, 1)] = c[XY];
    full[at(1, 0)] = c[XY];
    full[at(1, YAW)] = c[YA];
    full[at(YAW, 1)] = c[YA];
    full[at(0, YAW)] = c[XA];
    full[at(YAW, 0)] = c[XA];
    return Doubles.wrap(full);
  }

  private static int at(int row, int column) {
    return row * AXES + column;
  }
}
