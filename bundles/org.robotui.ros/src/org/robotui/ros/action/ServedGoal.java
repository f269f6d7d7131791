package org.robotui.ros.action;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.robotui.message.DynamicMessage;
import org.robotui.message.ros.actionlib_msgs.GoalID;
import org.robotui.message.ros.actionlib_msgs.GoalStatus;

/** A goal of a client, and how far it got by the rules of actionlib. */
final class ServedGoal implements GoalTaker.Taken {

  /** Tells clients. */
  interface Voice {
    void changed();

    void feedback(GoalStatus status, DynamicMessage feedback);

    void result(GoalStatus status, Optional<DynamicMessage> result);
  }

  private final GoalID id;
  private final Voice voice;
  private int status = GoalStatus.PENDING;
  private String text = "";
  private boolean over;
  private boolean cancelled;
  private Optional<Runnable> cancelling = Optional.empty();
  private volatile long endedNanos;

  ServedGoal(GoalID id, Voice voice) {
    this.id = id;
    this.voice = voice;
  }

  GoalID id() {
    return id;
  }

  synchronized GoalStatus message() {
    return new GoalStatus(id, status, text);
  }

  synchronized boolean isOver() {
    return over;
  }

  long endedNanos() {
    return endedNanos;
  }

  /** A cancellation that came meanwhile is passed on. */
  void cancelledBy(Runnable way) {
    boolean late;
    synchronized (this) {
      late = cancelled && !over;
      cancelling = late ? Optional.empty() : Optional.of(way);
    }
    if (late) {
      way.run();
    }
  }

  /** Asks for its end, once. */
  void cancel() {
    Optional<Runnable> way;
    synchronized (this) {
      if (over) {
        return;
      }
      cancelled = true;
      status = isBegun() ? GoalStatus.PREEMPTING : GoalStatus.RECALLING;
      way = cancelling;
      cancelling = Optional.empty();
    }
    voice.changed();
    way.ifPresent(Runnable::run);
  }

  private boolean isBegun() {
    return status == GoalStatus.ACTIVE || status == GoalStatus.PREEMPTING;
  }

  @Override
  public void begun() {
    change(() -> {
      boolean news = !over && !isBegun();
      status = !news ? status : cancelled ? GoalStatus.PREEMPTING : GoalStatus.ACTIVE;
      return news;
    }, now -> voice.changed());
  }

  @Override
  public void feedback(DynamicMessage feedback) {
    change(() -> !over, now -> voice.feedback(now, feedback));
  }

  @Override
  public void end(GoalEnd end, String words, Optional<DynamicMessage> result) {
    change(() -> {
      boolean first = !over;
      if (first) {
        status = code(end);
        text = words;
        over = true;
        endedNanos = System.nanoTime();
      }
      return first;
    }, now -> voice.result(now, result));
  }

  private void change(BooleanSupplier change, Consumer<GoalStatus> news) {
    Optional<GoalStatus> told;
    synchronized (this) {
      told = change.getAsBoolean() ? Optional.of(message()) : Optional.empty();
    }
    told.ifPresent(news);
  }

  /** Clients take no other step from where they are. */
  private int code(GoalEnd end) {
    return switch (end) {
      case SUCCEEDED -> GoalStatus.SUCCEEDED;
      case ABORTED, LOST -> GoalStatus.ABORTED;
      case REJECTED -> isBegun() ? GoalStatus.ABORTED : GoalStatus.REJECTED;
      case PREEMPTED -> GoalStatus.PREEMPTED;
      case RECALLED -> isBegun() ? GoalStatus.PREEMPTED : GoalStatus.RECALLED;
    };
  }
}
