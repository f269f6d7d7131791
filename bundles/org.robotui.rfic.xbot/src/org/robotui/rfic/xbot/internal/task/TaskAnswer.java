package org.robotui.rfic.xbot.internal.task;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * What a control answers where it is asked for the tasks of a plugin.
 *
 * @param joints those that it moves, by index
 * @param tasks the tasks, in the order of their priority
 */
record TaskAnswer(List<Integer> joints, List<FrameTask> tasks) {
  private static final int FIELDS = 8;
  private static final int LINK = 1;
  private static final int BASE = 2;
  private static final int PRIORITY = 3;
  private static final int PHASE = 4;
  private static final int MASK = 5;
  private static final int LINEAR = 6;
  private static final int ANGULAR = 7;

  /** Copies the lists. */
  TaskAnswer {
    joints = List.copyOf(joints);
    tasks = List.copyOf(tasks);
  }

  /** Reads an answer; none where it is no such answer. */
  static Optional<TaskAnswer> read(String plugin, String text) {
    String[] lines = text.split("\n", -1);
    try {
      List<Integer> joints =
          Stream.of(lines[0].split(" ")).filter(word -> !word.isEmpty()).map(Integer::valueOf).toList();
      List<FrameTask> tasks = new ArrayList<>();
      for (int i = 1; i < lines.length; i++) {
        tasks.add(task(plugin, lines[i].split("\t", -1)));
      }
      return Optional.of(new TaskAnswer(joints, tasks));
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  private static FrameTask task(String plugin, String[] fields) {
    if (fields.length != FIELDS || !fields[MASK].matches("[01]{6}")) {
      throw new IllegalArgumentException("no task");
    }
    return new FrameTask(plugin, fields[0], fields[LINK], fields[BASE], Integer.parseInt(fields[PRIORITY]),
        FrameTask.Phase.valueOf(fields[PHASE].toUpperCase(Locale.ROOT)), fields[MASK], speed(fields[LINEAR]),
        speed(fields[ANGULAR]));
  }

  private static double speed(String word) {
    double speed = Double.parseDouble(word);
    if (!(speed > 0) || !Double.isFinite(speed)) {
      throw new IllegalArgumentException("no speed: " + word);
    }
    return speed;
  }
}
