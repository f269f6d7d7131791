package org.robotui.uic.postures.internal;

import java.util.List;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.PluginReply;
import org.robotui.api.port.PluginRequest;
import org.robotui.api.port.Port;
import org.robotui.api.port.StreamPort;
import org.robotui.data.control.ControlPlugins;
import org.robotui.data.joint.JointControl;

/** The ports of the view. */
final class PosturesPorts {
  static final StreamPort<JointControl> CONTROL =
      new StreamPort<>("control", JointControl.class, Arity.ONE, "where the joints are, and where they are to be");
  static final StreamPort<ControlPlugins> PLUGINS =
      new StreamPort<>("plugins", ControlPlugins.class, Arity.ONE, "whether trajectories are followed, and how far");
  static final CallPort<PluginRequest, PluginReply> VERBS =
      new CallPort<>("plugin_verbs", PluginRequest.class, PluginReply.class, Arity.OPTIONAL,
          "starts the plugin that follows trajectories, and tells it where to go", true);

  static final List<Port> ALL = List.of(CONTROL, PLUGINS, VERBS);

  private PosturesPorts() {}
}
