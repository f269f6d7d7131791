/** Messages as streams and commands: which there are, and who wants them. */
package org.robotui.rfic.roblets.internal.feed;
