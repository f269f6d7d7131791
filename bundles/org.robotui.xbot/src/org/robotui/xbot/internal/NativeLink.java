package org.robotui.xbot.internal;

import java.io.IOException;
import java.nio.ByteBuffer;

/**
 * The native side of the link ({@code rt-native/jni}). Numbers named client and attachment are native objects: using
 * one after its end crashes the process, so only {@link NativeClient} and {@link Segments} call this. Texts are UTF-8.
 */
final class NativeLink {
  private static final String LIBRARY = "robotui_rt_jni";

  private NativeLink() {}

  /**
   * Loads the native library, once however often it is called.
   *
   * @throws IOException with a sentence for users where it is not there
   */
  static void load() throws IOException {
    try {
      System.loadLibrary(LIBRARY);
    } catch (UnsatisfiedLinkError e) {
      throw new IOException("the native library " + System.mapLibraryName(LIBRARY) + " is not there for this machine: "
          + e.getMessage(), e);
    }
  }

  static native long connect(byte[] robot, int timeoutMillis) throws IOException;

  static native boolean reconnect(long client, int timeoutMillis) throws IOException;

  static native long attach(long client, int timeoutMillis) throws IOException;

  static native int hosts(long attachment);

  static native ByteBuffer state(long attachment);

  static native ByteBuffer board(long attachment);

  static native ByteBuffer host(long attachment, int index) throws IOException;

  static native void detach(long attachment);

  /** Answers {@code ok TEXT} or {@code error SENTENCE}. */
  static native byte[] request(long client, byte[] words, int timeoutMillis) throws IOException;

  /** From a direct buffer that holds as many commands; false where the supervisor is gone. */
  static native boolean reference(long client, ByteBuffer commands, int joints) throws IOException;

  /** 0 nothing, 1 a segment was replaced, 2 the supervisor is gone. */
  static native int notice(long client, int timeoutMillis) throws IOException;

  static native void close(long client);
}
