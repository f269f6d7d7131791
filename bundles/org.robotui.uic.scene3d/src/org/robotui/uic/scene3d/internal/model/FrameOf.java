package org.robotui.uic.scene3d.internal.model;

import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.data.Bumpers;
import org.robotui.data.CameraInfo;
import org.robotui.data.Data;
import org.robotui.data.Footprint;
import org.robotui.data.FrameId;
import org.robotui.data.GridMap;
import org.robotui.data.Image;
import org.robotui.data.InteractiveMarker;
import org.robotui.data.InteractiveMarkerSet;
import org.robotui.data.LaserScan;
import org.robotui.data.Marker;
import org.robotui.data.MarkerSet;
import org.robotui.data.Path;
import org.robotui.data.PointCloud;
import org.robotui.data.Pose;
import org.robotui.data.PoseArray;
import org.robotui.data.RangeReading;
import org.robotui.data.RangeReadings;
import org.robotui.data.RobotDescription;
import org.robotui.data.Wrench;

/** The frames that data are given in: what a scene can be drawn in where no transform tells of any. */
final class FrameOf {
  private FrameOf() {}

  /** The robot that data are of. */
  static Optional<String> robot(Data value) {
    return value instanceof RobotDescription d ? Optional.of(d.robot()) : all(value).findFirst().map(FrameId::robot);
  }

  /** Every frame that they name, as often as they name it. */
  static Stream<FrameId> all(Data value) {
    Stream<FrameId> frames = switch (value) {
      case Pose p -> Stream.of(p.frame());
      case Image i -> Stream.of(i.frame());
      case CameraInfo c -> Stream.of(c.frame());
      case LaserScan s -> Stream.of(s.frame());
      case GridMap m -> Stream.of(m.frame());
      case PointCloud c -> Stream.of(c.frame());
      case Path p -> Stream.of(p.frame());
      case PoseArray p -> Stream.of(p.frame());
      case Footprint f -> Stream.of(f.frame());
      case Wrench w -> Stream.of(w.frame());
      case RangeReadings r -> r.readings().stream().map(RangeReading::frame);
      case Bumpers b -> Stream.of(b.frame());
      case MarkerSet m -> m.entries().stream().flatMap(e -> e.marker().stream()).map(Marker::frame);
      case InteractiveMarkerSet m -> m.entries().stream().flatMap(e -> e.marker().stream()).map(InteractiveMarker::frame);
      default -> Stream.empty();
    };
    return frames.filter(frame -> !frame.name().isEmpty());
  }
}
