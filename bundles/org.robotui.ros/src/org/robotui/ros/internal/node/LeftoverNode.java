package org.robotui.ros.internal.node;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.HostPort;
import org.robotui.ros.SystemState;
import org.robotui.ros.XmlRpcValue;

/**
 * A node that was written down. Its registrations are removed in its own name and only where the master has them at its
 * own address, which masters check, too: nothing of another node is touched, even of one with the same name.
 */
final class LeftoverNode {

  private final NodeRecord record;
  private final Duration perCall;
  private final XmlRpcValue caller;

  LeftoverNode(NodeRecord record, Duration perCall) {
    this.record = record;
    this.perCall = perCall;
    caller = XmlRpcValue.of(record.node());
  }

  /** Whether it may still run: its process does, it answers, or it belongs to another machine. */
  boolean mayRun() {
    return !record.owner().isOnThisHost() || record.owner().process().runs() || answers();
  }

  private boolean answers() {
    try (RosApi node = new RosApi(HostPort.ofUri(record.uri(), "http"), "", perCall)) {
      Outcome<XmlRpcValue> pid = node.call("getPid", caller);
      return pid.toOptional().filter(XmlRpcValue.of((int) record.owner().process().pid())::equals).isPresent();
    } catch (IllegalArgumentException e) {
      return false;
    }
  }

  /** Removes what the master has of it: how much that was, or why it is not known. */
  Outcome<Integer> remove() {
    try (RosApi master = new RosApi(HostPort.ofUri(record.master(), "http"), "master", perCall)) {
      Outcome<XmlRpcValue> address = master.call("lookupNode", caller, caller);
      return switch (address) {
        case Outcome.Done<XmlRpcValue> known -> known.value().equals(XmlRpcValue.of(record.uri())) ? removeAll(master)
            : new Outcome.Done<>(0);
        case Outcome.Refused<XmlRpcValue> unknown -> new Outcome.Done<>(0);
        case Outcome<XmlRpcValue> silent -> silent.map(never -> 0);
      };
    } catch (IllegalArgumentException e) {
      return new Outcome.Done<>(0);
    }
  }

  private Outcome<Integer> removeAll(RosApi master) {
    Outcome<SystemState> state = master.call("getSystemState", caller).map(GraphCodec::state);
    if (!(state instanceof Outcome.Done<SystemState> known)) {
      return state.map(never -> 0);
    }
    XmlRpcValue uri = XmlRpcValue.of(record.uri());
    List<Supplier<Outcome<XmlRpcValue>>> calls = new ArrayList<>();
    names(known.value().publishers())
        .forEach(topic -> calls.add(() -> master.call("unregisterPublisher", caller, topic, uri)));
    names(known.value().subscribers())
        .forEach(topic -> calls.add(() -> master.call("unregisterSubscriber", caller, topic, uri)));
    names(known.value().services()).forEach(
        service -> calls.add(() -> master.call("unregisterService", caller, service, XmlRpcValue.of(record.rpcUri()))));
    record.parameters()
        .forEach(key -> calls.add(() -> master.call("unsubscribeParam", caller, uri, XmlRpcValue.of(key))));
    return makeAll(calls);
  }

  /** Up to the first that the master does not answer: the others would only wait as long again. */
  private static Outcome<Integer> makeAll(List<Supplier<Outcome<XmlRpcValue>>> calls) {
    for (Supplier<Outcome<XmlRpcValue>> call : calls) {
      if (Thread.currentThread().isInterrupted()) {
        return new Outcome.Failed<>("interrupted");
      }
      Outcome<XmlRpcValue> outcome = call.get();
      if (outcome instanceof Outcome.Failed || outcome instanceof Outcome.TimedOut) {
        return outcome.map(never -> 0);
      }
    }
    return new Outcome.Done<>(calls.size());
  }

  private List<XmlRpcValue> names(Map<String, List<String>> nodesByName) {
    return nodesByName.entrySet().stream().filter(entry -> entry.getValue().contains(record.node()))
        .map(entry -> XmlRpcValue.of(entry.getKey())).toList();
  }
}
