package org.robotui.uic.scene3d.internal.model;

import java.util.Optional;
import org.robotui.data.Data;
import org.robotui.data.Footprint;
import org.robotui.data.FrameId;
import org.robotui.data.GridMap;
import org.robotui.data.Image;
import org.robotui.data.LaserScan;
import org.robotui.data.Path;
import org.robotui.data.PointCloud;
import org.robotui.data.Pose;
import org.robotui.data.PoseArray;
import org.robotui.data.RangeReading;
import org.robotui.data.RangeReadings;
import org.robotui.data.RobotDescription;

/** The frame that data are given in, for those types that a scene may have to be chosen by. */
final class FrameOf {
  private FrameOf() {}

  /** The robot that data are of. */
  static Optional<String> robot(Data value) {
    return value instanceof RobotDescription d ? Optional.of(d.robot()) : data(value).map(FrameId::robot);
  }

  static Optional<FrameId> data(Data value) {
    return switch (value) {
      case Pose p -> Optional.of(p.frame());
      case Image i -> Optional.of(i.frame());
      case LaserScan s -> Optional.of(s.frame());
      case GridMap m -> Optional.of(m.frame());
      case PointCloud c -> Optional.of(c.frame());
      case Path p -> Optional.of(p.frame());
      case PoseArray p -> Optional.of(p.frame());
      case Footprint f -> Optional.of(f.frame());
      case RangeReadings r -> r.readings().stream().findFirst().map(RangeReading::frame);
      default -> Optional.empty();
    };
  }
}
