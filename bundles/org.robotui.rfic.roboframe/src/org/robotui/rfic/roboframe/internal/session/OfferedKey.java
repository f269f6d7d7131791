package org.robotui.rfic.roboframe.internal.session;

import org.robotui.message.payload.PayloadFormat;
import org.robotui.roboframe.wire.BoardKey;

/**
 * A key of the application.
 *
 * @param key as the application says it
 * @param format reads its values
 */
record OfferedKey(BoardKey key, PayloadFormat format) {
  boolean isWritten() {
    return !key.writers().isEmpty();
  }

  boolean isRead() {
    return !key.readers().isEmpty();
  }
}
