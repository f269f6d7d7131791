package org.robotui.rfic.lcm.internal.language;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Where something stands in a message: names of members joined by dots, with indices in brackets; empty brackets stand
 * for all elements, as in {@code joints[].angle}. As brackets must be quoted within YAML's braces, {@code pos.0} and
 * {@code joints.*.angle} mean the same.
 *
 * @param steps from the outermost member inwards
 */
public record MemberPath(List<Step> steps) {
  private static final Pattern STEP = Pattern.compile("([A-Za-z_]\\w*)((?:\\[\\d{0,9}])*)");
  private static final Pattern INDEX = Pattern.compile("\\[(\\d*)]");

  /** A step of a path. */
  public sealed interface Step {
    /** Into a member. */
    record Name(String name) implements Step {}

    /** Into an element. */
    record Index(int index) implements Step {}

    /** Into all elements. */
    record All() implements Step {}
  }

  /** Copies the steps. */
  public MemberPath {
    steps = List.copyOf(steps);
  }

  /**
   * Reads a path.
   *
   * @param text the path
   * @return its steps
   * @throws IllegalArgumentException where it is none; the message says what to write
   */
  public static MemberPath parse(String text) {
    List<Step> steps = new ArrayList<>();
    for (String part : text.split("\\.", -1)) {
      if (!steps.isEmpty() && part.matches("\\d{1,9}|\\*")) {
        steps.add(part.equals("*") ? new Step.All() : new Step.Index(Integer.parseInt(part)));
        continue;
      }
      Matcher m = STEP.matcher(part);
      if (!m.matches()) {
        throw new IllegalArgumentException(
            "'" + text + "' names no member; write for example pos[0], pose.x or joints[].angle");
      }
      steps.add(new Step.Name(m.group(1)));
      INDEX.matcher(m.group(2)).results()
          .forEach(
              r -> steps.add(r.group(1).isEmpty() ? new Step.All() : new Step.Index(Integer.parseInt(r.group(1)))));
    }
    return new MemberPath(steps);
  }

  /** Whether it leads into all elements of something. */
  public boolean isMany() {
    return steps.stream().anyMatch(Step.All.class::isInstance);
  }

  @Override
  public String toString() {
    StringBuilder text = new StringBuilder();
    for (Step step : steps) {
      switch (step) {
        case Step.Name n -> text.append(text.isEmpty() ? "" : ".").append(n.name());
        case Step.Index i -> text.append('[').append(i.index()).append(']');
        case Step.All all -> text.append("[]");
      }
    }
    return text.toString();
  }
}
