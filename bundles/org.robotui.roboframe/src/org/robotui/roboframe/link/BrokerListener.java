package org.robotui.roboframe.link;

import java.io.IOException;
import java.util.List;
import org.robotui.roboframe.wire.BoardKey;
import org.robotui.roboframe.wire.BrokerMessage;

/** Takes what another application says, on the reading thread of its link; must not block. */
public interface BrokerListener {

  /**
   * The other application uses these keys now.
   *
   * @param link to it
   * @param keys all of them
   * @throws IOException where they cannot be used, which ends the link
   */
  void board(BrokerLink link, List<BoardKey> keys) throws IOException;

  /**
   * A value of a key has come.
   *
   * @param link by which it came
   * @param value nobody writes to its bytes again
   */
  void value(BrokerLink link, BrokerMessage.Value value);

  /**
   * The link has ended; told once.
   *
   * @param link that has ended
   * @param reason for users
   */
  void ended(BrokerLink link, String reason);
}
