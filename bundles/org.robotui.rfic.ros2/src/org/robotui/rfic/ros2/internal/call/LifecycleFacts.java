package org.robotui.rfic.ros2.internal.call;

import java.time.Duration;
import java.util.List;
import org.robotui.message.topic.ItemFacts;
import org.robotui.net.call.Outcome;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.graph.GraphState;
import org.robotui.ros2.lifecycle.LifecycleState;
import org.robotui.ros2.lifecycle.LifecycleTransition;
import org.robotui.ros2.lifecycle.Ros2Lifecycle;
import org.robotui.ros2.name.Ros2Name;

/** What a node with a life cycle says of it. */
final class LifecycleFacts {
  private static final Duration PATIENCE = Duration.ofSeconds(2);

  private LifecycleFacts() {}

  /** Asks a node that has one for its state and for what it can do next. */
  static void add(ItemFacts facts, Ros2Node asking, Ros2Name node, GraphState state) {
    if (!Ros2Lifecycle.nodes(state).contains(node)) {
      return;
    }
    try (Ros2Lifecycle cycle = Ros2Lifecycle.open(asking, node)) {
      Outcome<LifecycleState> now = cycle.state(PATIENCE);
      facts.with("state", now.toOptional().map(LifecycleState::label).orElseGet(now::reason));
      List<String> next = cycle.transitions(PATIENCE).toOptional().orElse(List.of()).stream()
          .map(LifecycleFacts::words).toList();
      facts.with("transitions", next);
    }
  }

  /** As {@code change_state} takes it. */
  private static String words(LifecycleTransition transition) {
    return transition.label() + " (" + transition.id() + ")";
  }
}
