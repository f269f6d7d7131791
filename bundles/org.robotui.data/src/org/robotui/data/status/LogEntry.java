package org.robotui.data.status;

import org.robotui.data.Conflation;
import org.robotui.data.Data;
import org.robotui.data.Delivery;
import org.robotui.data.Late;

/**
 * A line of a robot's log.
 *
 * @param severity how bad
 * @param origin the node or module that says it
 * @param message the text
 * @param location where in its code, may be empty
 */
@Delivery(conflation = Conflation.EVENT, late = Late.NONE, expires = false)
public record LogEntry(Severity severity, String origin, String message, String location) implements Data {}
