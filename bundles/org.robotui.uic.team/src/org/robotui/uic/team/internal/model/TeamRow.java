package org.robotui.uic.team.internal.model;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.geometry.Vector3;
import org.robotui.ui.Health;

/**
 * One robot.
 *
 * @param robot its name
 * @param number its place in the configuration, from 0, which gives it its colour
 * @param framework what it speaks
 * @param link the state of its link
 * @param linkHealth what to think of that
 * @param linkText why it is so, may be empty
 * @param doing what it is doing
 * @param state the same in words, with figures
 * @param why what is to be said of that, may be empty
 * @param charge of its battery, from 0 to 1, NaN where it is not known
 * @param battery the same in words
 * @param task what it was told to do, empty where that is not known
 * @param taskHealth what to think of that
 * @param place where it is in the common frame
 * @param frame the common frame, or that of the robot where they are not joined
 * @param age of what it said last, seconds, NaN before the first
 */
public record TeamRow(
    String robot,
    int number,
    String framework,
    String link,
    Health linkHealth,
    String linkText,
    Activity doing,
    String state,
    String why,
    double charge,
    String battery,
    String task,
    Health taskHealth,
    Optional<Vector3> place,
    String frame,
    double age) {

  /** Whether it has all these words somewhere. */
  boolean matches(List<String> words) {
    String all =
        Stream.of(robot, framework, link, state, task, why).reduce("", (a, b) -> a + " " + b).toLowerCase(Locale.ROOT);
    return words.stream().allMatch(all::contains);
  }
}
