package org.robotui.roboframe.app;

/**
 * A part of an application. It is called by one thread only. What it throws stops this module alone, and is told by the
 * application's channels {@code application/modules} and {@code application/log}.
 */
public interface RoboModule {

  /**
   * Begins: requests the keys that it reads and advertises those that it writes.
   *
   * @param channels are revoked by the application when the module ends
   * @return when it runs
   * @throws Exception where it cannot begin
   */
  RunPace init(ModuleChannels channels) throws Exception;

  /**
   * Does its work once.
   *
   * @throws Exception which stops it
   */
  void run() throws Exception;

  /**
   * Ends, also after an error.
   *
   * @throws Exception which is told
   */
  default void cleanUp() throws Exception {
    // most have nothing to give back
  }
}
