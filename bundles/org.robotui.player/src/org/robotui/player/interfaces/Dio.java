package org.robotui.player.interfaces;

import org.robotui.player.layout.Kind;

/** Digital inputs and outputs. The interface {@code dio}. */
public final class Dio {

  /** Data: inputs. */
  public static final Kind.Data<Inputs> INPUTS = new Kind.Data<>("dio", "inputs", Inputs.class);

  /** Command: outputs. */
  public static final Kind.Command<Outputs> OUTPUTS = new Kind.Command<>("dio", "outputs", Outputs.class);

  private Dio() {}

  /**
   * What the inputs are at.
   *
   * @param count how many there are
   * @param bits the first is the lowest bit
   */
  public record Inputs(long count, long bits) {}

  /**
   * What to put out.
   *
   * @param count how many are set
   * @param bits the first is the lowest bit
   */
  public record Outputs(long count, long bits) {}
}
