package org.robotui.uic.jointcontrol.internal.model;

import org.robotui.ui.Health;

/**
 * The heading of a chain.
 *
 * @param chain its name, empty for the joints in none
 * @param joints how many there are
 * @param words how they are doing, for a reader
 * @param health of the worst of them
 * @param open whether its joints are listed below
 */
public record ChainHead(String chain, int joints, String words, Health health, boolean open) implements JointLine {
  @Override
  public String key() {
    return "chain " + chain;
  }

  /** As users read it. */
  public String title() {
    return chain.isEmpty() ? "In no chain" : chain;
  }
}
