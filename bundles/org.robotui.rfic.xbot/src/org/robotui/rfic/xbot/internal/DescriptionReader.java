package org.robotui.rfic.xbot.internal;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.data.joint.RobotDescription;
import org.robotui.xbot.Answer;

/** Asks a control for the texts it was started with, piece by piece. */
final class DescriptionReader {
  private final Supervisor supervisor;

  /** Who is asked. */
  @FunctionalInterface
  interface Supervisor {
    Answer ask(String words) throws IOException;
  }

  DescriptionReader(Supervisor supervisor) {
    this.supervisor = supervisor;
  }

  /** What the robot is made of; none where the control does not say it. */
  Optional<RobotDescription> read(String robot, String packagePath) throws IOException {
    List<String> roots = Stream.of(packagePath.split(":")).filter(folder -> folder.startsWith("/")).toList();
    String urdf = text("urdf");
    return urdf.isBlank() ? Optional.empty()
        : Optional.of(new RobotDescription(robot, "the control's URDF", urdf, text("srdf"), roots));
  }

  /** Empty where it is not told, makes no progress, or is too long. */
  private String text(String which) throws IOException {
    StringBuilder text = new StringBuilder();
    long offset = 0;
    do {
      Answer answer = supervisor.ask("describe " + which + " " + offset);
      int space = answer.text().indexOf(' ');
      if (!answer.ok() || space < 0) {
        return "";
      }
      long next = number(answer.text().substring(0, space));
      String piece = answer.text().substring(space + 1);
      if (next != 0 && next != offset + piece.getBytes(StandardCharsets.UTF_8).length || next != 0 && piece.isEmpty()
          || text.length() + piece.length() > RobotDescription.LONGEST) {
        return "";
      }
      text.append(piece);
      offset = next;
    } while (offset > 0);
    return text.toString();
  }

  private static long number(String word) {
    return word.matches("\\d{1,18}") ? Long.parseLong(word) : -1;
  }
}
