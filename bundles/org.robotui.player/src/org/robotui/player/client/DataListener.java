package org.robotui.player.client;

/**
 * Hears one kind of data of a device. All calls come from the receiving thread, one after another, and must not block.
 *
 * @param <T> the record of the data
 */
@FunctionalInterface
public interface DataListener<T> {

  /**
   * Data came.
   *
   * @param value the data
   * @param stamp when they were measured, seconds of the server's clock
   * @param receiveNanos when the last byte was read, by {@link System#nanoTime()}
   */
  void onData(T value, double stamp, long receiveNanos);

  /**
   * Data came that cannot be read. The link stays: other devices are not concerned.
   *
   * @param reason names server, device, message and field, for a user to read
   */
  default void onProblem(String reason) {}
}
