package org.robotui.uic.postures.internal.model;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.SettingsStore;
import org.robotui.api.config.ValueType;

/**
 * Postures in the order in which they are gone through.
 *
 * @param postures the first one first
 */
public record PostureSequence(List<Posture> postures) {
  /** Without postures. */
  public static final PostureSequence NONE = new PostureSequence(List.of());
  /** The most postures. */
  public static final int MOST = 200;

  static final String POSTURES = "postures";
  static final String NAME = "name";
  static final String SECONDS = "seconds";
  static final String JOINTS = "joints";
  static final double FARTHEST = 1e6;

  /** Copies the list. */
  public PostureSequence {
    postures = List.copyOf(postures);
  }

  /** How it stands in a configuration. */
  public static Setting setting() {
    Schema posture = Schema.of(
        Setting.required(NAME, new ValueType.Text(), "What the posture is called."),
        Setting.of(SECONDS, new ValueType.Num(Posture.SHORTEST, Posture.LONGEST, "s"), 3.0,
            "How long the way to it takes, at least."),
        Setting.required(JOINTS, new ValueType.MapOf(new ValueType.Num(-FARTHEST, FARTHEST, "")),
            "Positions by joint, radians or metres; joints that are not named stay where they are."));
    return Setting.of(POSTURES, new ValueType.ListOf(new ValueType.Section(posture)), List.of(),
        "Postures that the robot goes through, one after the other.");
  }

  /** Reads that of the settings. */
  public static PostureSequence read(Settings settings) {
    return new PostureSequence(settings.list(POSTURES).stream().limit(MOST).map(PostureSequence::posture).toList());
  }

  /** Keeps it in the settings. */
  public void write(SettingsStore settings) {
    settings.set(POSTURES, postures.stream().<Object>map(Posture::fields).toList());
  }

  private static Posture posture(Object group) {
    Map<?, ?> fields = group instanceof Settings s ? s.values() : group instanceof Map<?, ?> m ? m : Map.of();
    Map<String, Double> joints = new LinkedHashMap<>();
    if (fields.get(JOINTS) instanceof Map<?, ?> named) {
      named.forEach((joint, position) -> joints.put(joint.toString(), number(position, 0)));
    }
    return new Posture(String.valueOf(fields.get(NAME)), number(fields.get(SECONDS), 3), joints);
  }

  private static double number(Object value, double otherwise) {
    return value instanceof Number number ? number.doubleValue() : otherwise;
  }

  PostureSequence plus(Posture posture) {
    return changed(list -> list.add(posture));
  }

  PostureSequence with(int index, Posture posture) {
    return changed(list -> list.set(index, posture));
  }

  PostureSequence without(int index) {
    return changed(list -> list.remove(index));
  }

  /** With a posture one place earlier (-1) or later (1), where there is one. */
  PostureSequence moved(int index, int by) {
    boolean fits = index + by >= 0 && index + by < postures.size();
    return fits ? changed(list -> Collections.swap(list, index, index + by)) : this;
  }

  /** A name that none has. */
  String freshName() {
    List<String> taken = postures.stream().map(Posture::name).toList();
    return IntStream.iterate(postures.size() + 1, i -> i + 1).mapToObj(i -> "Posture " + i)
        .filter(name -> !taken.contains(name)).findFirst().orElseThrow();
  }

  private PostureSequence changed(Consumer<List<Posture>> change) {
    List<Posture> list = new ArrayList<>(postures);
    change.accept(list);
    return new PostureSequence(list);
  }
}
