package org.robotui.roboframe.app;

import org.robotui.roboframe.board.ChannelKey;
import org.robotui.roboframe.board.KeyOutput;

/** The channels of one module. */
public interface ModuleChannels {

  /**
   * Requests a key.
   *
   * @param key which
   * @param <T> its values
   * @return what has come
   * @throws IllegalArgumentException where the key carries another type
   */
  <T> KeyInput<T> request(ChannelKey<T> key);

  /**
   * Advertises a key.
   *
   * @param key which
   * @param <T> its values
   * @return writes it
   * @throws IllegalArgumentException where the key carries another type
   */
  <T> KeyOutput<T> advertise(ChannelKey<T> key);
}
