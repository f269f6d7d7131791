package org.robotui.api.port;

import org.robotui.api.port.Caller.Call;
import org.robotui.api.port.Caller.Progress;
import org.robotui.data.record.DynamicRecord;

/**
 * An action for the programs of a robot that is carried out outside of it, such as by another robot. It is offered for
 * {@link ServiceOffer#LIFETIME_SECONDS}, and longer where it is offered again until then. When it is offered no longer,
 * its goals are cancelled.
 *
 * @param action the robot's name of the action
 * @param type the robot's name of its type, such as {@code nav2_msgs/NavigateToPose}
 * @param worker carries out goals
 */
public record ActionOffer(String action, String type, Worker worker) {
  /** Carries out goals. Safe for all threads. */
  @FunctionalInterface
  public interface Worker {
    /**
     * Begins with a goal. Must not block.
     *
     * @param goal its fields
     * @param client who asks, as the robot calls it; empty where it does not say
     * @param progress is told the feedback, and how far it is: a message that begins with {@code active} or
     * {@code executing} says that the robot works on it, as the calls of {@link ActionRequest} do. Until then a goal
     * that fails is told as rejected
     * @return the goal under way; its outcome never completes exceptionally, and cancelling it does not wait
     */
    Call<ActionReply> begin(DynamicRecord goal, String client, Progress progress);
  }
}
