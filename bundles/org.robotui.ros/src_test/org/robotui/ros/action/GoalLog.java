package org.robotui.ros.action;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.message.DynamicMessage;
import org.robotui.ros.Eventually;

/** Remembers what a goal's listener heard. */
final class GoalLog implements GoalListener {

  final List<GoalPhase> phases = new CopyOnWriteArrayList<>();
  final List<Double> feedback = new CopyOnWriteArrayList<>();
  final List<GoalOutcome> outcomes = new CopyOnWriteArrayList<>();

  @Override
  public void onPhase(GoalPhase phase, String text) {
    phases.add(phase);
  }

  @Override
  public void onFeedback(DynamicMessage message) {
    feedback.add(message.number("base_position.pose.position.x").orElse(-1));
  }

  @Override
  public void onDone(GoalOutcome outcome) {
    outcomes.add(outcome);
  }

  void awaitPhase(GoalPhase phase) {
    Eventually.await(phase + " among " + phases, () -> phases.contains(phase));
  }

  GoalOutcome awaitEnd() {
    Eventually.await("the end after " + phases, () -> !outcomes.isEmpty());
    return outcomes.get(0);
  }
}
