package org.robotui.rfic.yarp.internal.feed;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.api.config.Placed;
import org.robotui.data.joint.RobotDescription;

/**
 * The file in which a user says how the robot is built, as no port of YARP does.
 *
 * @param urdf where it is; an SRDF of the same name beside it is read, too
 */
public record ModelFile(Path urdf) {
  /** The file that a setting names. */
  public static ModelFile of(Placed setting) {
    return new ModelFile(setting.resolve(String.valueOf(setting.value())));
  }

  /** What is wrong with the file, for users. */
  public Optional<String> fault() {
    try {
      read("robot");
      return Optional.empty();
    } catch (IOException | IllegalArgumentException e) {
      return Optional.of("the model of the robot cannot be read: " + e.getMessage() + "; name a file with a URDF");
    }
  }

  /** Reads it; an {@link IllegalArgumentException} says that it is empty or too long. */
  public RobotDescription read(String robot) throws IOException {
    Path srdf = urdf.resolveSibling(urdf.getFileName().toString().replaceFirst("\\.[^.]*$", "") + ".srdf");
    List<String> roots = Stream.iterate(urdf.getParent(), folder -> folder != null, Path::getParent).skip(1).limit(2)
        .map(Path::toString).toList();
    return new RobotDescription(robot, urdf.getFileName().toString(), text(urdf),
        Files.isReadable(srdf) ? text(srdf) : "", roots);
  }

  private static String text(Path file) throws IOException {
    if (!Files.isRegularFile(file)) {
      throw new IOException(file + " is no file");
    }
    if (Files.size(file) > RobotDescription.LONGEST) {
      throw new IllegalArgumentException(file + " is longer than " + RobotDescription.LONGEST + " bytes");
    }
    return Files.readString(file);
  }
}
