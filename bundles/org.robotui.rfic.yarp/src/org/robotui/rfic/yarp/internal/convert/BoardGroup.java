package org.robotui.rfic.yarp.internal.convert;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.robotui.data.joint.JointModel;

/**
 * The joints of several control boards as those of one robot. A name that two boards use has the name of the board
 * before it.
 *
 * @param boards whose joints are known
 */
public record BoardGroup(List<BoardModel> boards) {
  /** With a list of its own. */
  public BoardGroup {
    boards = List.copyOf(boards);
  }

  /** A board with its joints as they are called here. */
  public BoardModel named(BoardModel board) {
    Set<String> twice = twice();
    return twice.isEmpty() ? board
        : new BoardModel(board.chain(), board.joints().stream()
            .map(j -> twice.contains(j.name()) ? called(j, board.chain() + "/" + j.name(), j.id()) : j).toList());
  }

  private Set<String> twice() {
    Set<String> seen = new HashSet<>();
    Set<String> twice = new HashSet<>();
    boards.forEach(board -> board.joints().stream().map(JointModel.Joint::name).filter(name -> !seen.add(name))
        .forEach(twice::add));
    return twice;
  }

  private static JointModel.Joint called(JointModel.Joint joint, String name, int id) {
    return new JointModel.Joint(name, id, joint.type(), joint.lower(), joint.upper(), joint.velocity(),
        joint.effort());
  }

  /** As views take it: joints are counted through all boards, each of which is a chain. */
  public JointModel model() {
    List<JointModel.Joint> joints = new ArrayList<>();
    List<JointModel.Chain> chains = new ArrayList<>();
    for (BoardModel board : boards) {
      JointModel one = named(board).model();
      one.joints().forEach(j -> joints.add(called(j, j.name(), joints.size())));
      chains.addAll(one.chains());
    }
    return new JointModel(joints, chains);
  }
}
