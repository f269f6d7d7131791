package org.robotui.uic.postures.internal.model;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.InputState;
import org.robotui.data.control.ControlPlugins;
import org.robotui.data.joint.JointControl;

/**
 * What is known of the robot at one moment.
 *
 * @param state of the joints' stream
 * @param measured where joints are, radians or metres; those that are not known are not in it
 * @param references where joints were told to be
 * @param plugins by name
 */
record RobotNow(InputState state, Map<String, Double> measured, Map<String, Double> references,
    Map<String, ControlPlugins.Plugin> plugins) {
  static RobotNow of(InputState state, Optional<JointControl> control, Optional<ControlPlugins> plugins) {
    Map<String, Double> measured = new LinkedHashMap<>();
    Map<String, Double> references = new LinkedHashMap<>();
    control.ifPresent(c -> c.joints().forEach(joint -> {
      put(measured, joint.name(), joint.measured().position());
      put(references, joint.name(), joint.reference().position());
    }));
    Map<String, ControlPlugins.Plugin> named = new LinkedHashMap<>();
    plugins.ifPresent(p -> p.plugins().forEach(plugin -> named.put(plugin.name(), plugin)));
    return new RobotNow(state, measured, references, named);
  }

  private static void put(Map<String, Double> into, String joint, double position) {
    if (Double.isFinite(position)) {
      into.put(joint, position);
    }
  }

  boolean isLive() {
    return state instanceof InputState.Live;
  }

  Optional<ControlPlugins.Plugin> plugin(String name) {
    return Optional.ofNullable(plugins.get(name));
  }

  boolean isRunning(String plugin) {
    return plugin(plugin).filter(p -> p.state() == ControlPlugins.State.RUNNING).isPresent();
  }

  /** Whether all joints of a posture are told to be there: then its way has been gone to its end. */
  boolean isToldToBeAt(Posture posture) {
    return posture.joints().entrySet().stream().allMatch(
        joint -> Math.abs(references.getOrDefault(joint.getKey(), Double.NaN) - joint.getValue()) < POSITION_STEP);
  }

  /** More than positions lose when they are written, less than any hand notices: radians or metres. */
  private static final double POSITION_STEP = 1e-3;
}
