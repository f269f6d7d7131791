package org.robotui.ros2.internal.action;

import java.util.Map;
import java.util.concurrent.ThreadFactory;
import org.robotui.message.DynamicMessage;
import org.robotui.ros2.action.Ros2GoalEnd;
import org.robotui.ros2.action.Ros2GoalTaker;
import org.robotui.ros2.action.Ros2GoalWorker;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Has a worker work on each goal on a thread of its own.
 *
 * @param action the name of the action
 * @param threads makes the threads
 * @param worker works on goals
 */
public record GoalThreads(String action, ThreadFactory threads, Ros2GoalWorker worker) implements Ros2GoalTaker {

  private static final Logger LOG = LoggerFactory.getLogger(GoalThreads.class);

  @Override
  public Runnable take(DynamicMessage goal, Taken taken) {
    Work work = new Work((ServerGoal) taken);
    if (worker.accept(goal)) {
      taken.accept();
      Thread thread = threads.newThread(() -> work(goal, work));
      thread.setName("goal of " + action);
      thread.start();
    } else {
      work.goal.end(Ros2GoalEnd.REJECTED, Map.of());
    }
    return () -> work.cancelled = true;
  }

  private void work(DynamicMessage wanted, Work work) {
    Ros2GoalWorker.End end = new Ros2GoalWorker.End(Ros2GoalEnd.ABORTED, Map.of());
    try {
      end = worker.work(wanted, work);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (RuntimeException e) {
      LOG.error("work on a goal of {} failed", action, e);
    }
    work.goal.end(end.end(), end.result());
  }

  private static final class Work implements Ros2GoalWorker.Running {
    private final ServerGoal goal;
    private volatile boolean cancelled;

    Work(ServerGoal goal) {
      this.goal = goal;
    }

    @Override
    public boolean cancelled() {
      return cancelled;
    }

    @Override
    public void feedback(Map<String, ?> values) {
      goal.tell(values);
    }
  }
}
