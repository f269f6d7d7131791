package org.robotui.ros2.graph;

/** Who is in the domain. Nobody is asked: it is what others announce. Any thread may use it. */
public interface Ros2Graph {

  /**
   * The graph.
   *
   * @return as of now, with this process
   */
  GraphState state();

  /**
   * Listens to changes.
   *
   * @param listener called on the receiving thread or the timer of the context after something changed, often many
   * times in a row; must not block
   * @return closing it ends the subscription
   */
  AutoCloseable onChange(Runnable listener);
}
