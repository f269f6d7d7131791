package org.robotui.rfic.yarp.internal.call;

import java.io.IOException;
import java.time.Duration;
import java.util.Map;
import java.util.Set;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.HostPort;
import org.robotui.rfic.yarp.internal.convert.BottleRecord;
import org.robotui.rfic.yarp.internal.feed.Wires;
import org.robotui.rfic.yarp.internal.feed.YarpDevices;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.BottleText;
import org.robotui.yarp.bottle.YarpFormatException;
import org.robotui.yarp.port.PortCall;

/** Asks ports by their names, with a bottle as people write it. What drives is left to views for driving. */
public final class YarpCalls implements CallHandler<ServiceRequest, ServiceReply> {
  static final String ARGUMENT = "command";
  private static final Set<String> DRIVING = Set.of("pos", "poss", "posg", "dpo", "dpos", "dpog", "rel", "rels", "relg",
      "vmo", "vmos", "velg", "trq", "trqs", "toq", "toqs", "pwms", "refp");
  private static final Set<String> GOING = Set.of("applyVelocityCommandRPC", "apply", "goto", "follow");

  private final Wires wires;
  private final YarpDevices devices;

  public YarpCalls(Wires wires, YarpDevices devices) {
    this.wires = wires;
    this.devices = devices;
  }

  @Override
  public ServiceReply handle(Invocation<ServiceRequest> invocation) throws CallException {
    ServiceRequest asked = invocation.request();
    String name = devices.kinds().entrySet().stream()
        .filter(e -> e.getValue().asked()
            && (e.getKey().equals(asked.service()) || wires.port(e.getKey()).equals(asked.service())))
        .map(Map.Entry::getKey).findFirst()
        .orElseThrow(() -> new CallException("no port '" + asked.service() + "' is there that can be asked"));
    Bottle question = question(asked);
    if (drives(question)) {
      throw new CallException("'" + question + "' drives the robot; use a view for driving");
    }
    HostPort where = devices.addresses().get(name);
    try (PortCall call = PortCall.connect(where, wires.own() + "/rpc", wires.options())) {
      Duration left = Duration.ofNanos(Math.max(1_000_000, invocation.deadlineNanos() - System.nanoTime()));
      Outcome<Bottle> outcome = call.ask(question, left);
      Bottle answer = outcome.toOptional().orElseThrow(() -> new CallException(outcome.reason()));
      return new ServiceReply(new BottleRecord(name, answer));
    } catch (IOException e) {
      throw new CallException(e.getMessage(), e);
    }
  }

  private static Bottle question(ServiceRequest asked) throws CallException {
    if (!(asked.arguments().get(ARGUMENT) instanceof String text) || asked.arguments().size() != 1) {
      throw new CallException(asked.service() + " is asked by one text, '" + ARGUMENT + "', such as [get] [axes]");
    }
    try {
      return BottleText.parse(text);
    } catch (YarpFormatException e) {
      throw new CallException("'" + text + "' is no bottle: " + e.getMessage(), e);
    }
  }

  /** Velocities, positions and goals are said by who holds the robot, within limits, and stopped with it. */
  private static boolean drives(Bottle question) {
    boolean sets = question.get(0).text().equals("set")
        && question.values().stream().limit(3).anyMatch(word -> DRIVING.contains(word.text()));
    boolean mode = question.get(1).text().equals("icmd");
    return sets && !mode || GOING.contains(question.get(0).text());
  }
}
