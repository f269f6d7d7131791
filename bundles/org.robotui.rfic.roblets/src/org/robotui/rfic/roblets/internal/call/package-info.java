/** What roblets are asked, and what a brain lists. */
package org.robotui.rfic.roblets.internal.call;
