package org.robotui.rfic.xbot.internal.task;

/**
 * One frame that a plugin brings to poses.
 *
 * @param plugin its plugin
 * @param name in commands; empty where they name none
 * @param link whose frame it is
 * @param base the link in whose frame its poses are
 * @param priority from 1, which comes first
 * @param phase how far it is
 * @param mask six digits for x, y, z, roll, pitch and yaw: 1 where the task has it
 * @param linear m/s, at most
 * @param angular rad/s, at most
 */
record FrameTask(String plugin, String name, String link, String base, int priority, Phase phase, String mask,
    double linear, double angular) {
  /** How far a task is. */
  enum Phase {
    /** It does nothing until it is enabled. */
    DISABLED,
    /** At its target. */
    THERE,
    /** On its way. */
    MOVING,
    /** It cannot go on. */
    STUCK
  }

  /** One among all of a robot. */
  String key() {
    return name.isEmpty() ? plugin : plugin + "/" + name;
  }

  /** What users call it. */
  String label() {
    return name.isEmpty() ? plugin : name;
  }

  /** An order for it, as its plugin takes it. */
  String order(String verb, String numbers) {
    return String.join(" ", verb, name, numbers).replaceAll(" +", " ").strip();
  }

  boolean has(int axis) {
    return mask.charAt(axis) == '1';
  }
}
