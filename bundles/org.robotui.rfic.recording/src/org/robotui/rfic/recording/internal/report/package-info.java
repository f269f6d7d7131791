/** Reports of recordings as pages that need nothing else: what happened, when, where, with figures and pictures. */
package org.robotui.rfic.recording.internal.report;
