package org.robotui.ros2.internal.parameter;

import java.time.Duration;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Stream;
import org.robotui.net.call.Outcome;
import org.robotui.net.log.PeerText;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2ServiceClient;
import org.robotui.ros2.Ros2ServiceCodec;
import org.robotui.ros2.Ros2SubscriberOptions;
import org.robotui.ros2.internal.msgs.DescribeParametersAsk;
import org.robotui.ros2.internal.msgs.GetParametersAsk;
import org.robotui.ros2.internal.msgs.ListParametersAsk;
import org.robotui.ros2.internal.msgs.SetParametersAsk;
import org.robotui.ros2.internal.msgs.SetParametersAtomicallyAsk;
import org.robotui.ros2.internal.msgs.WireEvent;
import org.robotui.ros2.internal.msgs.WireParameter;
import org.robotui.ros2.internal.msgs.WireSetResult;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.ros2.parameter.Ros2ParameterDescriptor;
import org.robotui.ros2.parameter.Ros2ParameterEvent;
import org.robotui.ros2.parameter.Ros2ParameterValue;
import org.robotui.ros2.parameter.Ros2Parameters;

/** Asks one node for its parameters. A client of a service is there for its calls only: nodes have six of them each. */
public final class ParameterClient implements Ros2Parameters {

  private final Ros2Node asking;
  private final Ros2Name asked;
  private final Duration timeout;
  private volatile boolean closed;

  /**
   * Prepares to ask.
   *
   * @param asking asks
   * @param asked whose parameters
   * @param timeout for each call
   */
  public ParameterClient(Ros2Node asking, Ros2Name asked, Duration timeout) {
    this.asking = asking;
    this.asked = asked;
    this.timeout = timeout;
  }

  /**
   * Follows the parameters of all nodes.
   *
   * @param node listens
   * @param listener hears what changed
   * @return closing it ends the subscription
   */
  public static AutoCloseable follow(Ros2Node node, Consumer<Ros2ParameterEvent> listener) {
    return node.subscriber(ParameterServices.EVENTS, Ros2Codec.of(WireEvent.class),
        new Ros2SubscriberOptions(QosProfiles.PARAMETER_EVENTS, true),
        (event, from) -> Ros2Name.parse(event.node()).ifPresent(name -> listener.accept(event(name, event))));
  }

  private static Ros2ParameterEvent event(Ros2Name node, WireEvent event) {
    Map<String, Ros2ParameterValue> values = new LinkedHashMap<>();
    Stream.concat(event.newParameters().stream(), event.changedParameters().stream())
        .forEach(each -> values.put(each.name(), WireValues.read(each.value())));
    Set<String> deleted = new HashSet<>();
    event.deletedParameters().forEach(each -> deleted.add(each.name()));
    return new Ros2ParameterEvent(node, values, deleted);
  }

  @Override
  public Ros2Name node() {
    return asked;
  }

  private <Q, R, A> Outcome<A> ask(String service, Ros2ServiceCodec<Q, R> codec, Q request,
      Function<R, Outcome<A>> answer) {
    if (closed) {
      return new Outcome.Failed<>("parameters of " + asked + ": closed");
    }
    try (Ros2ServiceClient<Q, R> client =
        asking.serviceClient(asked.join(service).text(), codec, QosProfiles.PARAMETERS)) {
      return switch (client.call(request, timeout)) {
        case Outcome.Done<R> done -> answer.apply(done.value());
        case Outcome.Refused<R> refused -> new Outcome.Refused<>(refused.reason());
        case Outcome.Failed<R> failed -> new Outcome.Failed<>(failed.reason());
        case Outcome.TimedOut<R> late -> new Outcome.TimedOut<>(late.reason(), late.after());
      };
    }
  }

  @Override
  public Outcome<List<String>> names() {
    return ask("list_parameters", ParameterServices.list(), new ListParametersAsk(List.of(), 0),
        reply -> new Outcome.Done<>(reply.result().names()));
  }

  @Override
  public Outcome<Map<String, Ros2ParameterValue>> get(List<String> names) {
    return ask("get_parameters", ParameterServices.get(), new GetParametersAsk(names),
        reply -> byName(names, reply.values(), WireValues::read));
  }

  @Override
  public Outcome<Map<String, Ros2ParameterDescriptor>> describe(List<String> names) {
    return ask("describe_parameters", ParameterServices.describe(), new DescribeParametersAsk(names),
        reply -> byName(names, reply.descriptors(), WireValues::read));
  }

  /** Nodes answer with nothing at all where they do not know one of the names. */
  private <W, V> Outcome<Map<String, V>> byName(List<String> names, List<W> answers, Function<W, V> read) {
    if (answers.size() != names.size()) {
      return new Outcome.Refused<>(asked + " answers for " + answers.size() + " of the " + names.size()
          + " parameters " + PeerText.brief(String.join(", ", names)) + ": it does not have them all");
    }
    Map<String, V> found = new LinkedHashMap<>();
    for (int i = 0; i < names.size(); i++) {
      found.put(names.get(i), read.apply(answers.get(i)));
    }
    return new Outcome.Done<>(found);
  }

  @Override
  public Outcome<Boolean> set(String name, Ros2ParameterValue value) {
    return ask("set_parameters", ParameterServices.set(), new SetParametersAsk(wire(Map.of(name, value))),
        reply -> reply.results().isEmpty() ? new Outcome.Failed<>(asked + " did not say whether it set " + name)
            : result(reply.results().get(0)));
  }

  @Override
  public Outcome<Boolean> setAll(Map<String, Ros2ParameterValue> values) {
    return ask("set_parameters_atomically", ParameterServices.setAll(), new SetParametersAtomicallyAsk(wire(values)),
        reply -> result(reply.result()));
  }

  private static List<WireParameter> wire(Map<String, Ros2ParameterValue> values) {
    return values.entrySet().stream().map(each -> new WireParameter(each.getKey(), WireValues.write(each.getValue())))
        .toList();
  }

  private Outcome<Boolean> result(WireSetResult result) {
    return result.successful() ? new Outcome.Done<>(true)
        : new Outcome.Refused<>(asked + ": " + PeerText.brief(result.reason()));
  }

  @Override
  public void close() {
    closed = true;
  }
}
