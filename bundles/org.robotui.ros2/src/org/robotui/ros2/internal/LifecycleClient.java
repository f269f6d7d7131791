package org.robotui.ros2.internal;

import java.time.Duration;
import java.util.List;
import java.util.function.Consumer;
import org.robotui.message.description.TypeName;
import org.robotui.net.call.Outcome;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2ServiceClient;
import org.robotui.ros2.Ros2ServiceCodec;
import org.robotui.ros2.Ros2SubscriberOptions;
import org.robotui.ros2.internal.msgs.ChangeStateAsk;
import org.robotui.ros2.internal.msgs.ChangeStateReply;
import org.robotui.ros2.internal.msgs.GetAvailableTransitionsAsk;
import org.robotui.ros2.internal.msgs.GetAvailableTransitionsReply;
import org.robotui.ros2.internal.msgs.GetStateAsk;
import org.robotui.ros2.internal.msgs.GetStateReply;
import org.robotui.ros2.internal.msgs.WireState;
import org.robotui.ros2.internal.msgs.WireTransition;
import org.robotui.ros2.internal.msgs.WireTransitionEvent;
import org.robotui.ros2.lifecycle.LifecycleState;
import org.robotui.ros2.lifecycle.LifecycleTransition;
import org.robotui.ros2.lifecycle.Ros2Lifecycle;
import org.robotui.ros2.name.Ros2Name;

/** Asks one node for its life cycle. */
public final class LifecycleClient implements Ros2Lifecycle {

  /** The type of the service that nodes with a life cycle have. */
  public static final TypeName CHANGE_STATE = new TypeName("lifecycle_msgs", TypeName.Kind.SRV, "ChangeState");

  private static final String PACKAGE = "lifecycle_msgs/srv/";

  private final Ros2Node asking;
  private final Ros2Name asked;
  private final Ros2ServiceClient<GetStateAsk, GetStateReply> state;
  private final Ros2ServiceClient<GetAvailableTransitionsAsk, GetAvailableTransitionsReply> transitions;
  private final Ros2ServiceClient<ChangeStateAsk, ChangeStateReply> change;

  /**
   * Prepares to ask.
   *
   * @param asking asks
   * @param asked whose life cycle
   */
  public LifecycleClient(Ros2Node asking, Ros2Name asked) {
    this.asking = asking;
    this.asked = asked;
    state = asking.serviceClient(asked.join("get_state").text(),
        Ros2ServiceCodec.of(PACKAGE + "GetState", GetStateAsk.class, GetStateReply.class));
    transitions = asking.serviceClient(asked.join("get_available_transitions").text(), Ros2ServiceCodec.of(
        PACKAGE + "GetAvailableTransitions", GetAvailableTransitionsAsk.class, GetAvailableTransitionsReply.class));
    change = asking.serviceClient(asked.join("change_state").text(),
        Ros2ServiceCodec.of(PACKAGE + "ChangeState", ChangeStateAsk.class, ChangeStateReply.class));
  }

  @Override
  public Ros2Name node() {
    return asked;
  }

  @Override
  public Outcome<LifecycleState> state(Duration timeout) {
    return state.call(new GetStateAsk(), timeout).map(reply -> read(reply.currentState()));
  }

  @Override
  public Outcome<List<LifecycleTransition>> transitions(Duration timeout) {
    return transitions.call(new GetAvailableTransitionsAsk(), timeout).map(reply -> reply.availableTransitions()
        .stream().map(each -> read(each.transition(), each.startState(), each.goalState())).toList());
  }

  @Override
  public Outcome<Boolean> change(int transition, Duration timeout) {
    Outcome<ChangeStateReply> answer =
        change.call(new ChangeStateAsk(new WireTransition(transition, "")), timeout);
    return answer instanceof Outcome.Done<ChangeStateReply> done && !done.value().success()
        ? new Outcome.Refused<>(asked + " could not make transition " + transition)
        : answer.map(ChangeStateReply::success);
  }

  @Override
  public AutoCloseable follow(Consumer<LifecycleTransition> listener) {
    return asking.subscriber(asked.join("transition_event").text(), Ros2Codec.of(WireTransitionEvent.class),
        new Ros2SubscriberOptions(QosProfiles.DEFAULT, true),
        (event, from) -> listener.accept(read(event.transition(), event.startState(), event.goalState())));
  }

  private static LifecycleTransition read(WireTransition transition, WireState start, WireState goal) {
    return new LifecycleTransition(transition.id(), transition.label(), read(start), read(goal));
  }

  private static LifecycleState read(WireState state) {
    return new LifecycleState(state.id(), state.label());
  }

  @Override
  public void close() {
    state.close();
    transitions.close();
    change.close();
  }
}
