package org.robotui.rfic.xbot.internal;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.robotui.rfic.xbot.internal.follow.FollowLink;
import org.robotui.xbot.Answer;
import org.robotui.xbot.Board;
import org.robotui.xbot.RtClient;
import org.robotui.xbot.StateFrame;

/**
 * Has trajectories followed by the control that a client is connected to.
 *
 * @param client the connection
 * @param patience how long an answer may take
 */
record SupervisorLink(RtClient client, Duration patience) implements FollowLink {
  @Override
  public Answer ask(String words) {
    try {
      return client.request(words, patience);
    } catch (IOException e) {
      return new Answer(false, e.getMessage());
    }
  }

  @Override
  public List<String> joints() {
    return client.board().map(board -> board.joints().stream().map(Board.Joint::name).toList()).orElse(List.of());
  }

  @Override
  public List<Board.Plugin> plugins() {
    return client.board().map(Board::plugins).orElse(List.of());
  }

  @Override
  public Optional<StateFrame> state() {
    return client.state();
  }
}
