package org.robotui.uic.postures.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.port.SourceId;
import org.robotui.data.control.ControlPlugins;
import org.robotui.data.control.ControlPlugins.State;
import org.robotui.data.control.Histogram;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointControl.Measured;
import org.robotui.data.joint.JointControl.Reference;
import org.robotui.data.joint.JointControl.Source;
import org.robotui.data.joint.JointMode;
import org.robotui.testkit.FakeUicContext;

/** An arm of two joints and its control, as a test has them. */
public final class ArmNow {
  /** Who answers. */
  public static final SourceId VERBS = new SourceId("base", "plugin_verbs");
  /** What follows trajectories. */
  public static final String PLUGIN = "JointTrajectory";
  /** What lets joints be moved by hand. */
  public static final String GUIDE = "GravityCompensation";

  private static final SourceId CONTROL = new SourceId("base", "control");
  private static final SourceId PLUGINS = new SourceId("base", "plugins");

  private final FakeUicContext context;

  /** Of a view. */
  public ArmNow(FakeUicContext context) {
    this.context = context;
  }

  /** Where its joints are, and are told to be. */
  public ArmNow at(double shoulder, double elbow) {
    context.input(PosturesPorts.CONTROL).put(CONTROL,
        new JointControl(List.of(joint("shoulder", shoulder), joint("elbow", elbow))), 0, Optional.empty());
    return this;
  }

  /** What its plugin says. */
  public ArmNow plugin(State state, String status) {
    return plugins(state, status, State.STOPPED);
  }

  /** What its plugins say. */
  public ArmNow plugins(State state, String status, State guide) {
    List<ControlPlugins.Plugin> plugins = new ArrayList<>();
    Map.of(PLUGIN, state, GUIDE, guide).forEach((name, now) -> plugins.add(new ControlPlugins.Plugin(name, name, "rt",
        "main", now, name.equals(PLUGIN) ? status : "", "", 0, 1_000_000, 5, new Histogram(List.of(), List.of(), 0))));
    context.input(PosturesPorts.PLUGINS).put(PLUGINS, new ControlPlugins(plugins), 0, Optional.empty());
    return this;
  }

  private static JointControl.Joint joint(String name, double position) {
    return new JointControl.Joint(name, new Measured(position, position, 0, 0, 0, 40, 38),
        new Reference(position, 0, 0, 0, 0), Set.of(JointMode.POSITION), Source.COMMANDED, PLUGIN, 0, 0, 0);
  }
}
