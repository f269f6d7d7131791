package org.robotui.sim.internal.lcm;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.robotui.lcm.type.LcmRecord;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.RecordBuilder;
import org.robotui.lcm.type.TypeFolder;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.sim.internal.world.Pose2;

/** The types of the package {@code robotui}, read from their files. */
final class Types {
  private static final String PACKAGE = "robotui.";

  private final Path folder;
  private final TypeLibrary library;

  private Types(Path folder, TypeLibrary library) {
    this.folder = folder;
    this.library = library;
  }

  /** @throws IOException if files cannot be read or are wrong; names them */
  static Types read(Path folder) throws IOException {
    TypeLibrary library = TypeFolder.read(List.of(folder));
    if (!library.problems().isEmpty()) {
      throw new IOException(library.problems().getFirst().getMessage());
    }
    return new Types(folder, library);
  }

  /** @throws IllegalArgumentException if there is no file of the type */
  LcmType type(String name) {
    return library.type(PACKAGE + name).orElseThrow(() -> new IllegalArgumentException(
        "the type " + PACKAGE + name + " is in no file of " + folder
            + "; give the folder with the types of the package robotui"));
  }

  /** @throws IllegalArgumentException if the type has no such constant */
  long constant(String typeName, String constant) {
    return type(typeName).definition().constants().stream().filter(each -> each.name().equals(constant)).findFirst()
        .map(each -> each.value().longValue())
        .orElseThrow(() -> new IllegalArgumentException(
            "the type " + PACKAGE + typeName + " in " + folder + " has no constant " + constant));
  }

  /** A record with its time, microseconds since 1970. */
  RecordBuilder make(String name, long utime) {
    return type(name).builder().whole("utime", utime);
  }

  LcmRecord pose(long utime, String frame, Pose2 pose) {
    return make("pose_t", utime).text("frame", frame).numbers("position", pose.x(), pose.y(), 0)
        .numbers("orientation", turned(pose.yaw())).build();
  }

  /** A place on the robot, or of a frame in another. */
  LcmRecord transform(long utime, String parent, String child, Pose2 pose, double height) {
    return make("transform_t", utime).text("parent", parent).text("child", child)
        .numbers("position", pose.x(), pose.y(), height).numbers("orientation", turned(pose.yaw())).build();
  }

  /** A turn about the vertical axis: w, x, y, z. */
  static double[] turned(double yaw) {
    return new double[]{Math.cos(yaw / 2), 0, 0, Math.sin(yaw / 2)};
  }
}
