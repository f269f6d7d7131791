package org.robotui.bridge.internal.change;

import java.util.HashMap;
import java.util.Map;
import org.robotui.api.config.Settings;
import org.robotui.data.FrameId;

/**
 * What frames of one robot are called by another one.
 *
 * @param robot the robot that hears of them
 * @param names other names, by the names of the robot that says them
 * @param prefix what stands before all others
 * @param stripped whether the prefix is taken away, not put there
 */
public record FrameRenaming(String robot, Map<String, String> names, String prefix, boolean stripped) {
  /** Takes a copy. */
  public FrameRenaming {
    names = Map.copyOf(names);
  }

  /** As configured, for values that go to a robot. */
  public static FrameRenaming of(Settings settings, String robot) {
    Map<String, String> names = new HashMap<>();
    if (settings.has("frames")) {
      settings.map("frames").forEach((name, other) -> names.put(bare(name.toString()), other.toString()));
    }
    return new FrameRenaming(robot, names, settings.has("frame_prefix") ? settings.text("frame_prefix") : "", false);
  }

  /** The way back. */
  public FrameRenaming back(String other) {
    Map<String, String> back = new HashMap<>();
    names.forEach((name, renamed) -> back.put(renamed, name));
    return new FrameRenaming(other, back, prefix, !stripped);
  }

  /** Whether all names stay what they are. */
  public boolean isNone() {
    return names.isEmpty() && prefix.isEmpty();
  }

  FrameId of(FrameId frame) {
    return new FrameId(robot, of(frame.name()));
  }

  String of(String name) {
    String bare = bare(name);
    if (bare.isEmpty() || names.containsKey(bare)) {
      return names.getOrDefault(bare, name);
    }
    if (prefix.isEmpty()) {
      return name;
    }
    return !stripped ? prefix + bare : bare.startsWith(prefix) ? bare.substring(prefix.length()) : name;
  }

  private static String bare(String name) {
    return name.startsWith("/") ? name.substring(1) : name;
  }
}
