package org.robotui.rfic.yarp.internal.feed;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.data.joint.JointModel;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.HostPort;
import org.robotui.rfic.yarp.internal.convert.BoardModel;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.YarpValue;
import org.robotui.yarp.port.PortCall;

/** Asks a control board for its joints: how they are called, which of them slide, and their limits. */
final class AskedBoard {
  private static final int MOST = 256;
  private static final Duration PATIENCE = Duration.ofMillis(700);
  private static final int VALUE = 2;

  private final PortCall call;
  private final String chain;

  private AskedBoard(PortCall call, String chain) {
    this.call = call;
    this.chain = chain;
  }

  /** Blocks; an {@link IOException} says why the board does not tell. */
  static BoardModel ask(Wires wires, HostPort rpc, String chain) throws IOException {
    try (PortCall call = PortCall.connect(rpc, wires.own() + "/rpc", wires.options())) {
      return new AskedBoard(call, chain).model();
    }
  }

  private BoardModel model() throws IOException {
    double axes = get("axes", Optional.empty()).get(VALUE).number();
    if (!(axes >= 0) || axes > MOST) {
      throw new IOException(chain + " says that it has " + axes + " joints");
    }
    List<JointModel.Joint> joints = new ArrayList<>();
    for (int i = 0; i < axes; i++) {
      joints.add(joint(i));
    }
    return new BoardModel(chain, joints);
  }

  /** What a board does not tell is taken to be without a limit. */
  private JointModel.Joint joint(int index) throws IOException {
    String name = get("name", Optional.of(index)).get(VALUE).text();
    boolean slides = get("type", Optional.of(index)).get(VALUE).text().equals("atpr");
    Bottle limits = get("llim", Optional.of(index));
    Bottle speeds = get("vlim", Optional.of(index));
    boolean told = name.isEmpty() || name.equals("undocumented");
    return new JointModel.Joint(told ? chain + "_" + index : name, index,
        slides ? JointModel.Type.PRISMATIC : JointModel.Type.REVOLUTE,
        si(slides, limits.get(VALUE), Double.NEGATIVE_INFINITY),
        si(slides, limits.get(VALUE + 1), Double.POSITIVE_INFINITY),
        si(slides, speeds.get(VALUE + 1), Double.POSITIVE_INFINITY), Double.POSITIVE_INFINITY);
  }

  private static double si(boolean slides, YarpValue value, double otherwise) {
    double number = value.number();
    return Double.isNaN(number) ? otherwise : slides ? number : Math.toRadians(number);
  }

  /** What follows {@code [is]}; an empty answer where the board does not know. */
  private Bottle get(String what, Optional<Integer> joint) throws IOException {
    List<YarpValue> question = new ArrayList<>(Bottle.vocabs("get", what));
    joint.ifPresent(index -> question.add(new YarpValue.Whole(index, Integer.SIZE)));
    Outcome<Bottle> outcome = call.ask(Bottle.of(question), PATIENCE);
    Bottle answer = outcome.toOptional().orElseThrow(() -> new IOException(outcome.reason()));
    boolean known = answer.get(0).text().equals("is") && answer.get(answer.size() - 1).text().equals("ok");
    return known ? answer : Bottle.of();
  }
}
