/** Player's log files, as the server's own driver {@code writelog} writes them: text, a message a line. */
package org.robotui.player.log;
