package org.robotui.rfic.yarp.internal.feed;

import java.util.Optional;
import org.robotui.api.RficContext;
import org.robotui.api.link.Pulse;
import org.robotui.api.session.PlacedFrames;
import org.robotui.api.session.RobotFrames;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;
import org.robotui.net.thread.Workers;
import org.robotui.rfic.yarp.internal.YarpSettings;
import org.robotui.yarp.name.NameClient;
import org.robotui.yarp.port.PortAdmin;
import org.robotui.yarp.port.PortOptions;
import org.robotui.yarp.wire.YarpStamp;

/**
 * What all ports of a session share.
 *
 * @param context what core gives
 * @param settings of the robot interface
 * @param names asks the name server
 * @param options of connections
 * @param workers run what writes
 * @param own the name of our port
 * @param frames names of frames
 * @param tree the robot's frames
 * @param pulse hears of all messages
 */
public record Wires(RficContext context, YarpSettings settings, NameClient names, PortOptions options, Workers workers,
    String own, RobotFrames frames, PlacedFrames tree, Pulse pulse) {
  private static final double NANOS = 1e9;
  private static final double LAST = 9e9;

  PortAdmin admin() {
    return new PortAdmin(options);
  }

  /** Devices say when they measured by the clock of their machine; 0 is no time. */
  Optional<Stamp> stamp(Optional<YarpStamp> envelope) {
    double seconds = envelope.map(YarpStamp::seconds).orElse(0.0);
    if (!(seconds > 0) || seconds > LAST) {
      return Optional.empty();
    }
    long nanos = Math.round(seconds * NANOS);
    context.clock().observed(nanos);
    return Optional.of(new Stamp(nanos, ClockKind.ROBOT));
  }

  /** The name of a port here: without what begins all of them, the first slash, and the mark of an output. */
  public String port(String name) {
    String rest = name.startsWith(settings.prefix()) ? name.substring(settings.prefix().length()) : name;
    String bare = rest.startsWith("/") ? rest.substring(1) : rest;
    return bare.endsWith(":o") ? bare.substring(0, bare.length() - 2) : bare;
  }

  /** What all ports of a device begin with. */
  static String device(String port) {
    int slash = port.lastIndexOf('/');
    return slash <= 0 ? port : port.substring(0, slash);
  }
}
