package org.robotui.ros2.internal.parameter;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.Function;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Publisher;
import org.robotui.ros2.Ros2ServiceServer;
import org.robotui.ros2.internal.msgs.DescribeParametersReply;
import org.robotui.ros2.internal.msgs.GetParameterTypesReply;
import org.robotui.ros2.internal.msgs.GetParametersReply;
import org.robotui.ros2.internal.msgs.ListParametersAsk;
import org.robotui.ros2.internal.msgs.ListParametersReply;
import org.robotui.ros2.internal.msgs.SetParametersAtomicallyReply;
import org.robotui.ros2.internal.msgs.SetParametersReply;
import org.robotui.ros2.internal.msgs.WireEvent;
import org.robotui.ros2.internal.msgs.WireListResult;
import org.robotui.ros2.internal.msgs.WireParameter;
import org.robotui.ros2.internal.msgs.WireSetResult;
import org.robotui.ros2.parameter.Ros2ParameterDescriptor;
import org.robotui.ros2.parameter.Ros2ParameterServer;
import org.robotui.ros2.parameter.Ros2ParameterValue;

/** The parameters of a node of ours. */
public final class ParameterHost implements Ros2ParameterServer {

  /** A parameter. */
  private record Held(Ros2ParameterDescriptor descriptor, Ros2ParameterValue value,
      Function<Ros2ParameterValue, Optional<String>> judge) {

    Optional<String> fault(Ros2ParameterValue wanted) {
      return descriptor.fault(wanted).or(() -> judge.apply(wanted));
    }
  }

  private final Ros2Node node;
  private final Map<String, Held> held = new LinkedHashMap<>();
  private final Ros2Publisher<WireEvent> events;
  private final List<Consumer<Map<String, Ros2ParameterValue>>> listeners = new CopyOnWriteArrayList<>();
  private final List<Ros2ServiceServer> services = new ArrayList<>();

  /**
   * Offers the services.
   *
   * @param node whose parameters
   */
  public ParameterHost(Ros2Node node) {
    this.node = node;
    events = node.publisher(ParameterServices.EVENTS, Ros2Codec.of(WireEvent.class), QosProfiles.PARAMETER_EVENTS);
    services.add(node.serviceServer("~/list_parameters", ParameterServices.list(), QosProfiles.PARAMETERS,
        (ask, caller) -> list(ask)));
    services.add(node.serviceServer("~/get_parameters", ParameterServices.get(), QosProfiles.PARAMETERS,
        (ask, caller) -> new GetParametersReply(
            ask.names().stream().map(name -> WireValues.write(value(name))).toList())));
    services.add(node.serviceServer("~/get_parameter_types", ParameterServices.types(), QosProfiles.PARAMETERS,
        (ask, caller) -> new GetParameterTypesReply(types(ask.names()))));
    services.add(node.serviceServer("~/describe_parameters", ParameterServices.describe(), QosProfiles.PARAMETERS,
        (ask, caller) -> describe(ask.names())));
    services.add(node.serviceServer("~/set_parameters", ParameterServices.set(), QosProfiles.PARAMETERS,
        (ask, caller) -> new SetParametersReply(ask.parameters().stream().map(each -> set(List.of(each))).toList())));
    services.add(node.serviceServer("~/set_parameters_atomically", ParameterServices.setAll(),
        QosProfiles.PARAMETERS, (ask, caller) -> new SetParametersAtomicallyReply(set(ask.parameters()))));
  }

  @Override
  public synchronized void declare(Ros2ParameterDescriptor descriptor, Ros2ParameterValue value,
      Function<Ros2ParameterValue, Optional<String>> judge) {
    if (held.putIfAbsent(descriptor.name(), new Held(descriptor, value, judge)) != null) {
      throw new IllegalArgumentException(node.name() + " has a parameter '" + descriptor.name() + "' already");
    }
    WireParameter wire = new WireParameter(descriptor.name(), WireValues.write(value));
    events.publish(
        new WireEvent(node.clock().nowNanos(), node.name().text(), List.of(wire), List.of(), List.of()));
  }

  @Override
  public synchronized Ros2ParameterValue value(String name) {
    Held known = held.get(name);
    return known == null ? new Ros2ParameterValue.Unset() : known.value();
  }

  @Override
  public void set(String name, Ros2ParameterValue value) {
    WireSetResult result = set(List.of(new WireParameter(name, WireValues.write(value))));
    if (!result.successful()) {
      throw new IllegalArgumentException(result.reason());
    }
  }

  private synchronized WireSetResult set(List<WireParameter> wanted) {
    for (WireParameter each : wanted) {
      Held known = held.get(each.name());
      Optional<String> fault = known == null ? Optional.of("there is no parameter '" + each.name() + "'")
          : known.fault(WireValues.read(each.value()));
      if (fault.isPresent()) {
        return new WireSetResult(false, fault.get());
      }
    }
    wanted.forEach(each -> held.computeIfPresent(each.name(),
        (name, known) -> new Held(known.descriptor(), WireValues.read(each.value()), known.judge())));
    events.publish(new WireEvent(node.clock().nowNanos(), node.name().text(), List.of(), wanted, List.of()));
    Map<String, Ros2ParameterValue> values = new LinkedHashMap<>();
    wanted.forEach(each -> values.put(each.name(), WireValues.read(each.value())));
    listeners.forEach(listener -> listener.accept(values));
    return new WireSetResult(true, "");
  }

  @Override
  public void onSet(Consumer<Map<String, Ros2ParameterValue>> listener) {
    listeners.add(listener);
  }

  private synchronized ListParametersReply list(ListParametersAsk ask) {
    List<String> names = held.keySet().stream().filter(name -> ask.prefixes().isEmpty()
        || ask.prefixes().stream().anyMatch(prefix -> name.equals(prefix) || name.startsWith(prefix + ".")))
        .filter(name -> ask.depth() == 0 || name.chars().filter(c -> c == '.').count() < ask.depth()).toList();
    List<String> prefixes = names.stream().filter(name -> name.contains("."))
        .map(name -> name.substring(0, name.lastIndexOf('.'))).distinct().toList();
    return new ListParametersReply(new WireListResult(names, prefixes));
  }

  private ByteBuffer types(List<String> names) {
    ByteBuffer types = ByteBuffer.allocate(names.size());
    names.forEach(name -> types.put((byte) value(name).type()));
    return types.flip();
  }

  /** As other nodes do, nothing is described where one of the names is not known. */
  private synchronized DescribeParametersReply describe(List<String> names) {
    boolean all = held.keySet().containsAll(names);
    return new DescribeParametersReply(all
        ? names.stream().map(name -> WireValues.write(held.get(name).descriptor())).toList()
        : List.of());
  }

  @Override
  public void close() {
    services.forEach(Ros2ServiceServer::close);
    events.close();
  }
}
