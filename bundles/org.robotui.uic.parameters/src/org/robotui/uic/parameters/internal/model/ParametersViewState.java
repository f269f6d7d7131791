package org.robotui.uic.parameters.internal.model;

import java.util.List;
import java.util.Optional;
import org.robotui.api.port.InputState;
import org.robotui.ui.ask.ControlFirst;

/**
 * All that the view shows, at one moment.
 *
 * @param tuning whether running programs are shown in place of parameters
 * @param state whether there is a robot that answers
 * @param rows the tree
 * @param parameters how many parameters there are
 * @param filter the words that are looked for
 * @param servers the programs whose settings can be changed while they run
 * @param panel the settings of the chosen one
 * @param notice what is wrong although there is something to show, empty where nothing is
 * @param told what became of the last thing that the user did
 * @param question what the user is asked
 * @param undo what can be undone, empty where nothing can
 */
public record ParametersViewState(
    boolean tuning,
    InputState state,
    List<ParameterRow> rows,
    int parameters,
    String filter,
    List<Key> servers,
    Optional<Panel> panel,
    String notice,
    ParameterNotice told,
    Optional<ControlFirst.Question> question,
    String undo) {}
