package org.robotui.uic.plugins.internal;

import java.util.List;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.PluginReply;
import org.robotui.api.port.PluginRequest;
import org.robotui.api.port.Port;
import org.robotui.api.port.StreamPort;
import org.robotui.data.control.ControlPlugins;
import org.robotui.data.control.Drives;
import org.robotui.data.control.LoopTiming;

/** The ports of the view. */
final class PluginsPorts {
  static final StreamPort<ControlPlugins> PLUGINS =
      new StreamPort<>("plugins", ControlPlugins.class, Arity.ONE, "the plugins of the control and how they are doing");
  static final StreamPort<LoopTiming> TIMING =
      new StreamPort<>("timing", LoopTiming.class, Arity.OPTIONAL,
          "how well the threads of the control keep their time");
  static final StreamPort<Drives> DRIVES =
      new StreamPort<>("drives", Drives.class, Arity.OPTIONAL, "where the drives of the joints stand");
  static final CallPort<PluginRequest, PluginReply> VERBS =
      new CallPort<>("plugin_verbs", PluginRequest.class, PluginReply.class,
          Arity.OPTIONAL, "starts, stops and reloads plugins; enables and disables drives", true);

  static final List<Port> ALL = List.of(PLUGINS, TIMING, DRIVES, VERBS);

  private PluginsPorts() {}
}
