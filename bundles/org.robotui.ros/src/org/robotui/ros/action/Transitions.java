package org.robotui.ros.action;

import static org.robotui.ros.action.GoalPhase.ACTIVE;
import static org.robotui.ros.action.GoalPhase.PENDING;
import static org.robotui.ros.action.GoalPhase.PREEMPTING;
import static org.robotui.ros.action.GoalPhase.RECALLING;
import static org.robotui.ros.action.GoalPhase.WAITING_FOR_RESULT;

import java.util.List;
import java.util.Optional;
import org.robotui.message.ros.actionlib_msgs.GoalStatus;

/**
 * The phases a goal goes through when its server reports a status, as actionlib's clients define them. As statuses come
 * some times a second only, phases may be skipped: they are gone through one after the other.
 */
final class Transitions {

  private Transitions() {}

  /** The phases to go through; none if the status tells nothing new; empty if no server may report it in this phase. */
  static Optional<List<GoalPhase>> next(GoalPhase from, int status) {
    return switch (from) {
      case WAITING_FOR_ACKNOWLEDGEMENT -> unacknowledged(status);
      case PENDING -> pending(status);
      case ACTIVE -> active(status);
      case WAITING_FOR_CANCEL -> isEarly(status) ? to() : cancelled(status);
      case RECALLING -> recalling(status);
      case PREEMPTING -> preempting(status);
      case WAITING_FOR_RESULT,
          DONE -> isEnd(status) || status == GoalStatus.ACTIVE && from == WAITING_FOR_RESULT ? to() : Optional.empty();
    };
  }

  private static Optional<List<GoalPhase>> to(GoalPhase... phases) {
    return Optional.of(List.of(phases));
  }

  private static boolean isEarly(int status) {
    return status == GoalStatus.PENDING || status == GoalStatus.ACTIVE;
  }

  private static boolean isEnd(int status) {
    return status != GoalStatus.LOST && GoalEnd.of(status).isPresent();
  }

  private static Optional<List<GoalPhase>> unacknowledged(int status) {
    return switch (status) {
      case GoalStatus.PENDING -> to(PENDING);
      case GoalStatus.REJECTED, GoalStatus.RECALLED -> to(PENDING, WAITING_FOR_RESULT);
      case GoalStatus.RECALLING -> to(PENDING, RECALLING);
      default -> begun(status);
    };
  }

  private static Optional<List<GoalPhase>> pending(int status) {
    return switch (status) {
      case GoalStatus.PENDING -> to();
      case GoalStatus.REJECTED -> to(WAITING_FOR_RESULT);
      case GoalStatus.RECALLING -> to(RECALLING);
      case GoalStatus.RECALLED -> to(RECALLING, WAITING_FOR_RESULT);
      default -> begun(status);
    };
  }

  /** Statuses that show that the server began with the goal. */
  private static Optional<List<GoalPhase>> begun(int status) {
    return switch (status) {
      case GoalStatus.ACTIVE -> to(ACTIVE);
      case GoalStatus.PREEMPTING -> to(ACTIVE, PREEMPTING);
      case GoalStatus.PREEMPTED -> to(ACTIVE, PREEMPTING, WAITING_FOR_RESULT);
      case GoalStatus.SUCCEEDED, GoalStatus.ABORTED -> to(ACTIVE, WAITING_FOR_RESULT);
      default -> Optional.empty();
    };
  }

  private static Optional<List<GoalPhase>> active(int status) {
    return switch (status) {
      case GoalStatus.ACTIVE -> to();
      case GoalStatus.PREEMPTING -> to(PREEMPTING);
      case GoalStatus.PREEMPTED -> to(PREEMPTING, WAITING_FOR_RESULT);
      case GoalStatus.SUCCEEDED, GoalStatus.ABORTED -> to(WAITING_FOR_RESULT);
      default -> Optional.empty();
    };
  }

  private static Optional<List<GoalPhase>> cancelled(int status) {
    return switch (status) {
      case GoalStatus.REJECTED -> to(WAITING_FOR_RESULT);
      case GoalStatus.RECALLING -> to(RECALLING);
      case GoalStatus.RECALLED -> to(RECALLING, WAITING_FOR_RESULT);
      case GoalStatus.PREEMPTING -> to(PREEMPTING);
      case GoalStatus.PREEMPTED, GoalStatus.SUCCEEDED, GoalStatus.ABORTED -> to(PREEMPTING, WAITING_FOR_RESULT);
      default -> Optional.empty();
    };
  }

  private static Optional<List<GoalPhase>> recalling(int status) {
    return switch (status) {
      case GoalStatus.RECALLING -> to();
      case GoalStatus.RECALLED -> to(WAITING_FOR_RESULT);
      default -> cancelled(status);
    };
  }

  private static Optional<List<GoalPhase>> preempting(int status) {
    return switch (status) {
      case GoalStatus.PREEMPTING -> to();
      case GoalStatus.PREEMPTED, GoalStatus.SUCCEEDED, GoalStatus.ABORTED -> to(WAITING_FOR_RESULT);
      default -> Optional.empty();
    };
  }
}
