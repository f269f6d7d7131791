package org.robotui.uic.log.internal.view;

import org.robotui.api.port.InputState;
import org.robotui.ui.StateView;
import org.robotui.uic.log.internal.model.LogFilter;
import org.robotui.uic.log.internal.model.Shown;

/**
 * What is painted next; immutable.
 *
 * @param shown the entries, as the last tick left them
 * @param filter what was asked for, which the entries may not follow yet
 * @param state of the input
 * @param paused whether the list is held
 * @param nodes whether the list of nodes is shown
 * @param told what became of what the user wanted, or empty
 */
public record Frame(Shown shown, LogFilter filter, InputState state, boolean paused, boolean nodes, String told) {
  /** Whether another differs in nothing but entries. */
  public boolean looksLike(Frame other) {
    return filter.equals(other.filter) && paused == other.paused && nodes == other.nodes && told.equals(other.told)
        && state.getClass() == other.state.getClass() && (state instanceof InputState.Live
            || StateView.word(state).equals(StateView.word(other.state))
                && state.explanation().equals(other.state.explanation()));
  }
}
