package org.robotui.rfic.lcm.internal.session;

import org.robotui.api.RficContext;
import org.robotui.lcm.LcmMessage;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.rfic.lcm.internal.LcmSettings;

/** Channels without a connection, for tests that have the messages themselves. */
public final class SessionProbe implements AutoCloseable {
  private final LcmChannels channels;

  /** Opens nothing. */
  public SessionProbe(RficContext context, LcmSettings settings, TypeLibrary types) {
    channels = new LcmChannels(context, settings, types, new SessionClock(context, false));
  }

  /** A message comes. */
  public void accept(LcmMessage message) {
    channels.accept(message);
  }

  @Override
  public void close() {
    channels.close();
  }
}
