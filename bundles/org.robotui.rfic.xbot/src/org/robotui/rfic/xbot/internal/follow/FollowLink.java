package org.robotui.rfic.xbot.internal.follow;

import java.util.List;
import java.util.Optional;
import org.robotui.xbot.Answer;
import org.robotui.xbot.Board;
import org.robotui.xbot.StateFrame;

/** What of a control is needed to have a trajectory followed. Any thread may use it. */
public interface FollowLink {
  /** Asks the supervisor, and waits for it: not ok where it does not answer. */
  Answer ask(String words);

  /** The joints of the robot, by index; none where the control says nothing. */
  List<String> joints();

  /** The plugins; none where the control says nothing. */
  List<Board.Plugin> plugins();

  /** The newest state. */
  Optional<StateFrame> state();
}
